// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace sheetmorph::numerics
{

//! Consecutive rows of a field, in float32.
struct alignas(64) ResponseRows
{
    static constexpr int count = 48;  //!< from the kernel: three of the widest registers of floats
    float at[count];
};

//! The same in steps of 16 bits.
struct alignas(32) NarrowRows
{
    std::int16_t at[ResponseRows::count];
};

//! The product of one patch: its fields, combined by shares * coefficients.
struct ResponseProduct
{
    static constexpr int lanes = 8;  //!< from AVX2: floats of a register; shares fill it
    //! Blocks of a patch. Chosen: the blended fields of a patch, 4.5 KiB, stay in the first cache.
    static constexpr int most_blocks = 8;
    static constexpr int most_fields = most_blocks * ResponseRows::count;

    const ResponseRows* wide;  //!< block by block, one for each wide field
    int wide_count;
    const NarrowRows* narrow;  //!< in the same order
    int narrow_count;
    int blocks;
    const float* shares;  //!< column by column: one for each field, filled up with zeros
    int columns;
    const double* coefficients;  //!< 3 per column
    double* result;              //!< 3 per row: fields * (shares * coefficients)
};

//! Uses the widest instructions of the processor.
void run_response_kernel(const ResponseProduct& work);

}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph
{

//! Rows of a response basis that lie together, in float32: one column after the other.
struct alignas(64) ResponseRows
{
    static constexpr int count = 48;
    float at[count];
};

//! A stretch of blocks of ResponseRows::count rows each.
struct ResponseBlocks
{
    const ResponseRows* basis;  //!< `columns` a block
    int columns;
    int blocks;
    const float* coefficients;  //!< 3 a column
    const double* start;        //!< 3 a row
    double* result;             //!< 3 a row: start + basis * coefficients
};

//! Uses the widest instructions the processor has.
void run_response_kernel(const ResponseBlocks& work);

}  // namespace sheetmorph

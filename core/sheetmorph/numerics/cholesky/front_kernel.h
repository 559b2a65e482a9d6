// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

namespace sheetmorph::numerics
{

//! Right-hand sides that are solved side by side: few_sides, from the three coordinates of one
//! shape, or many_sides, from the widest registers (8 doubles).
constexpr int few_sides = 4;
constexpr int many_sides = 8;

//! Whether solving for `many_sides` takes less time than twice for `few_sides`.
bool has_many_sides();

//! Right-hand sides and the fronts to solve with.
struct FrontRun
{
    const FrontList& factor;
    const std::vector<int>& nodes;    //!< fronts, ascending
    int sides;                        //!< few_sides or many_sides
    std::vector<double*> x;           //!< groups (slots, sides), row by row
    double* scratch;                  //!< (most columns of a front, sides)
    const int* top_row = nullptr;     //!< (slots) row of `above` or -1
    std::vector<double*> above = {};  //!< by group, (rows, sides); empty: subtract from x
};

//! Forward substitution: solves for the own rows of each front and subtracts their part from the
//! rows below.
void run_forward(const FrontRun& run);

//! The same for one front, with rows w (rows, sides), row by row.
void run_forward(const Front& front, int sides, double* w);

//! Backward substitution with the transposed factor, from the last front to the first.
void run_backward(const FrontRun& run);

}  // namespace sheetmorph::numerics

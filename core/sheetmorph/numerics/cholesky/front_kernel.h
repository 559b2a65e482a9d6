// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

namespace sheetmorph::numerics
{

//! How many right sides are computed side by side: few, as for one shape, or as many as the widest
//! instructions hold.
constexpr int few_sides = 4;
constexpr int many_sides = 8;

//! Whether `many_sides` take less time than twice `few_sides`.
bool has_many_sides();

//! Right sides on their way through fronts.
struct FrontRun
{
    const FrontList& factor;
    const std::vector<int>& nodes;    //!< fronts, ascending
    int sides;                        //!< few_sides or many_sides
    std::vector<double*> x;           //!< groups (slots, sides), row by row
    double* scratch;                  //!< (most columns of a front, sides)
    const int* top_row = nullptr;     //!< (slots) row of `above` or -1
    std::vector<double*> above = {};  //!< by group, (rows, sides); empty: all is taken off x
};

//! Solves for the own rows of one front after the other and takes their part off those below.
void run_forward(const FrontRun& run);

//! The same of one front whose rows are w (rows, sides), row by row.
void run_forward(const Front& front, int sides, double* w);

//! Solves for the own rows of the transposed, from the last front to the first.
void run_backward(const FrontRun& run);

}  // namespace sheetmorph::numerics

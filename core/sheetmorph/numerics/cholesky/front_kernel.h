// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

namespace sheetmorph
{

//! How many right sides are computed side by side: few, as for one shape, or as many as the widest
//! instructions hold.
constexpr int few_sides = 4;
constexpr int many_sides = 8;

//! Whether `many_sides` take less time than twice `few_sides`.
bool has_many_sides();

//! w (rows, sides), row by row: solves for the own rows and takes their part off the others.
//! \param sides  few_sides or many_sides
void run_forward(const Front& front, int sides, double* w);

//! w (rows, sides): solves for the own rows of the transposed, the others being known.
void run_backward(const Front& front, int sides, double* w);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

namespace sheetmorph
{

//! Four right sides at once, row by row.
constexpr int right_sides_at_once = 4;

//! w (rows, 4): solves for the own rows and takes their part off the others.
void run_forward(const Front& front, double* w);

//! w (rows, 4): solves for the own rows of the transposed, the others being known.
void run_backward(const Front& front, double* w);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph
{

//! One supernode of a factor L: `columns` columns that share their `rows` rows, the first `columns`
//! of them its own; column-major, leading dimension `rows`, the triangle above the diagonal unused.
struct Supernode
{
    const double* entries;
    int rows;
    int columns;
};

//! Four right sides at once, row by row.
constexpr int right_sides_at_once = 4;

//! w (rows, 4): solves for the own rows and takes their part off the others.
void run_forward(const Supernode& node, double* w);

//! w (rows, 4): solves for the own rows of the transposed, the others being known.
void run_backward(const Supernode& node, double* w);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::mesh
{

//! Height over longest edge below which a triangle counts as degenerate: its plane is undefined.
//! From files with seven digits: on a part ten elements long, a height of 1e-6 of an edge is the
//! last digit. Chosen ten times higher.
constexpr double thinnest_triangle = 1e-5;

//! Height over longest edge that operators give to a thinner triangle. From the condition:
//! cotangents then reach 1e4 and the energy, their square, 1e8, so doubles keep eight digits.
constexpr double thinnest_for_operators = 1e-4;

//! Whether a triangle repeats a vertex, or its height is below `thinnest_triangle` of its longest
//! edge.
bool is_thin(const Points& points, const Triangles& triangles, int triangle);

}  // namespace sheetmorph::mesh

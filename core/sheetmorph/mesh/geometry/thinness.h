// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::mesh
{

//! Height over longest edge below which a triangle counts as degenerate: its plane is undefined.
constexpr double thinnest_triangle = 1e-5;

//! Whether a triangle repeats a vertex, or its height is below `thinnest_triangle` of its longest
//! edge.
bool is_thin(const Points& points, const Triangles& triangles, int triangle);

}  // namespace sheetmorph::mesh

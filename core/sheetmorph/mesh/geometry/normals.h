// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::mesh
{

//! Normals of the vertices for display, (n, 3), each of length 1: the mean of the triangles around,
//! weighted by area. Where they cancel out, that of the first of the largest triangles; at a vertex
//! without any triangle of some area, (0, 0, 1).
//! \param points     (n, 3) mm
//! \param triangles  (m, 3) rows of `points`, checked by the caller
Points vertex_normals(const Points& points, const Triangles& triangles);

}  // namespace sheetmorph::mesh

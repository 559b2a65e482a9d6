// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::mesh
{

//! Vertex normals for display, (n, 3), length 1: the mean of the adjacent triangles' normals
//! weighted by area. If they cancel, the normal of the largest triangle (the first of equals). At a
//! vertex without a triangle of positive area, (0, 0, 1).
//! \param points     (n, 3) mm
//! \param triangles  (m, 3) rows of `points`, checked by the caller
Points vertex_normals(const Points& points, const Triangles& triangles);

}  // namespace sheetmorph::mesh

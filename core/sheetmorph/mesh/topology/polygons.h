// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::mesh
{

//! (q, 4) vertex indices, one row per quad, in order around it.
using Quads = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;

//! Splits quads into triangles for the stiffness K. Row k becomes rows 2k and 2k + 1 with the same
//! orientation, so that the element of triangle t is t / 2.
//!
//! The Delaunay diagonal is chosen, whose two opposite angles have the smaller sum. Its cotangent
//! weight is never negative. If both sums are equal (rectangles, trapezoids with equal legs), the
//! weight is zero for either diagonal. K therefore does not depend on the numbering of vertices or
//! corners, and mirrored quads give the mirrored K. A diagonal outside a quad with a re-entrant
//! corner is not used. If the sums are equal to 1e-9, the diagonal at the quad's first corner is
//! used.
//! \param points  (n, 3) mm
//! \throws InvalidInput naming the rows of `quads` with an index out of range
Triangles split_quads(const Points& points, const Quads& quads);

//! Splits a polygon of 3 or more corners, convex or not and nearly plane, into corners - 2
//! triangles of the same orientation. Cuts off the best-shaped ear until a quad is left.
//! \throws InvalidInput for fewer than three corners or an index out of range
Triangles split_polygon(const Points& points, const VertexIds& corners);

}  // namespace sheetmorph::mesh

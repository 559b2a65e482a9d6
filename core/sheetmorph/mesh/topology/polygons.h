// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::mesh
{

//! (q, 4) vertex indices, one row a quad, in order around it.
using Quads = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;

//! Splits quads into triangles for the stiffness K; row k becomes rows 2k and 2k + 1, oriented
//! like it, so that the element of triangle t is t / 2.
//!
//! Of the two diagonals the one is taken whose two opposite corners have the smaller sum of angles
//! (Delaunay): its cotangent weight is then never negative, and where both sums are equal - every
//! rectangle, every trapezoid with equal legs - it is zero for either diagonal. So K does not
//! depend on how vertices or corners are numbered, and mirrored quads give the mirrored K. A
//! diagonal that runs outside a quad with a re-entrant corner is not taken. Equal sums (to 1e-9):
//! the diagonal at the quad's first corner. \param points  (n, 3) mm \throws InvalidInput naming
//! the rows of `quads` with an index out of range
Triangles split_quads(const Points& points, const Quads& quads);

//! Splits one polygon of any number of corners >= 3, convex or not, nearly plane, into
//! corners - 2 triangles oriented like it: its best shaped ear is cut until a quad is left.
//! \throws InvalidInput for fewer than three corners or an index out of range
Triangles split_polygon(const Points& points, const VertexIds& corners);

}  // namespace sheetmorph::mesh

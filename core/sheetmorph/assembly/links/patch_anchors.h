// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <array>

namespace sheetmorph
{

//! A point of a region: beta_0 p_0 + beta_1 p_1 + beta_2 p_2 over three of its vertices.
struct PatchAnchor
{
    std::array<int, 3> corners{};
    Vector3 weights = Vector3::Zero();

    //! The point on rows of `points` (n, 3): positions, or rotation logs.
    Vector3 on(const Points& points) const;
};

//! For every target the nearest point of a region: on its triangles with all corners in the region,
//! or its nearest vertex if it has no such triangle (a straight row, a single vertex).
std::vector<PatchAnchor> nearest_anchors(const TriangleMesh& mesh, const VertexIds& region,
                                         const Points& targets);

//! The region with the triangles of the mesh that are nearest to the targets. What stands on a
//! coarse mesh, or on the wall of a sheet, touches triangles none of which the region has whole.
VertexIds with_triangles_below(const TriangleMesh& mesh, const VertexIds& region,
                               const Points& targets);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/anchor.h"
#include "sheetmorph/mesh/search/part_geometry.h"

namespace sheetmorph::assembly
{

//! The nearest point of a region for every target: on triangles with all corners in the region, or
//! its nearest vertex if it has no such triangle (a straight row, a single vertex).
std::vector<mesh::Anchor> nearest_anchors(const mesh::PartGeometry& part, const VertexIds& region,
                                          const Points& targets);

//! Whether a region has a triangle with all its corners.
bool has_triangles(const mesh::PartGeometry& part, const VertexIds& region);

//! The region, extended by the triangles of the mesh that are nearest to the targets. A part that
//! stands on a coarse mesh, or on the wall of a sheet, may touch only triangles that the region
//! does not contain completely.
VertexIds with_triangles_below(const mesh::PartGeometry& part, const VertexIds& region,
                               const Points& targets);

}  // namespace sheetmorph::assembly

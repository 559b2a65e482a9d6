// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/vertex_roles.h"

namespace sheetmorph::surface
{

//! Whether points are collinear, so that a sheet attached to them could still tilt.
bool are_in_line(const Points& points);

//! Input of hinged_vertices().
struct HingedInput
{
    const mesh::TriangleMesh& mesh;  //!< with glued borders where sheets end at each other
    const VertexRoles& roles;
    const std::vector<char>& clamps;  //!< (n) vertices that also fix the slope
    const std::vector<char>& is_interior;
};

//! Vertices of sheets that could tilt at no cost under `natural`, because rigid shapes and other
//! sheets only support them along a line. A sheet cannot tilt if it is supported by a whole face,
//! by a seam or, if it is flat, by points that are not collinear. A sheet supported by another one
//! counts only after that one is supported.
VertexIds hinged_vertices(const HingedInput& input);

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/vertex_roles.h"

namespace sheetmorph::surface
{

//! Whether points are that much longer than wide that they hold no sheet from tilting.
bool are_in_line(const Points& points);

//! What is asked whether it could tilt.
struct HingedInput
{
    const mesh::TriangleMesh& mesh;  //!< glued where sheets end at each other
    const VertexRoles& roles;
    const std::vector<char>& clamps;  //!< (n) vertices that hold the slope, too
    const std::vector<char>& is_interior;
};

//! Vertices of the sheets that rigid shapes and other sheets hold in line, so that they could tilt
//! at no cost in `natural`: by neither a face that is held whole, nor, where they are flat, by
//! places that are not in line, nor by a seam. What hangs on such a sheet counts once that is held.
VertexIds hinged_vertices(const HingedInput& input);

}  // namespace sheetmorph::surface

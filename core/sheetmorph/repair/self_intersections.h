// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <utility>

namespace sheetmorph::repair
{

//! The pairs of triangles, smaller index first, that meet anywhere but in the corners and sides
//! they share, told exactly; ascending. Triangles without area do not count.
std::vector<std::pair<int, int>> self_intersections(const mesh::TriangleMesh& mesh);

}  // namespace sheetmorph::repair

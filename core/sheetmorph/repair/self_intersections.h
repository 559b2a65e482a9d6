// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <utility>

namespace sheetmorph::repair
{

//! The pairs of triangles that meet anywhere except in shared corners and sides, by exact
//! predicates; smaller index first, ascending. Triangles without area are ignored.
std::vector<std::pair<int, int>> self_intersections(const mesh::TriangleMesh& mesh);

}  // namespace sheetmorph::repair

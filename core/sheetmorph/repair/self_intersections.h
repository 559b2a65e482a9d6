// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <utility>

namespace sheetmorph
{

//! The pairs of triangles, smaller index first, that meet anywhere but in what they share (CGAL,
//! Polygon Mesh Processing, exact predicates); ascending. Of triangles that more than two share an
//! edge of, those that are no neighbours there do not count.
//! \param mesh  no triangle repeats a vertex or stands twice
std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph
{

//! Triangles turned so that neighbours face the same way.
struct OrientedSoup
{
    Triangles triangles;           //!< (m, 3) the vertices given
    Triangles manifold_triangles;  //!< (m, 3) the same with copies of vertices, a manifold mesh
    std::vector<int> original;     //!< of each vertex of the latter: the vertex given
    int turned = 0;                //!< the fewest per mesh: how many triangles were turned
};

//! Orients triangles and cuts them along edges that more than two share, and at vertices that do
//! not hold them together (CGAL, orient_polygon_soup).
//! \param mesh  no triangle repeats a vertex or stands twice
OrientedSoup oriented(const TriangleMesh& mesh);

}  // namespace sheetmorph

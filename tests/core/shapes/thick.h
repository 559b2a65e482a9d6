// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/boundary.h"
#include "shapes/solids.h"

namespace sheetmorph::shapes
{

//! A flat sheet in z = 0 (normals along +z) as a thin solid from z = -thickness to 0: the sheet,
//! its lower side with the same numbers plus the sheet's vertex count, and a wall along every rim.
inline mesh::TriangleMesh thickened(const mesh::TriangleMesh& mesh, double thickness)
{
    const int count = mesh.vertex_count();
    Points points(2 * count, 3);
    points << mesh.points(), mesh.points();
    points.bottomRows(count).col(2).array() -= thickness;
    std::vector<int> corners(mesh.triangles().data(),
                             mesh.triangles().data() + mesh.triangles().size());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 2; k >= 0; --k)
            corners.push_back(mesh.triangles()(t, k) + count);
    for (const mesh::BoundaryEdge& edge : mesh::boundary_edges(mesh))
        for (const int id :
             {edge.to, edge.from, edge.from + count, edge.to, edge.from + count, edge.to + count})
            corners.push_back(id);
    return mesh::TriangleMesh(points, Eigen::Map<Triangles>(corners.data(), corners.size() / 3, 3));
}

//! The same triangles, each with corners of its own, as STL has them.
inline mesh::TriangleMesh unwelded(const mesh::TriangleMesh& mesh)
{
    Points points(mesh.triangles().size(), 3);
    Triangles triangles(mesh.triangle_count(), 3);
    for (int k = 0; k < mesh.triangles().size(); ++k)
    {
        points.row(k) = mesh.points().row(mesh.triangles().data()[k]);
        triangles.data()[k] = k;
    }
    return mesh::TriangleMesh(points, triangles);
}

}  // namespace sheetmorph::shapes

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes/variations.h"

namespace sheetmorph::shapes
{

//! The mesh with a node of no triangle before each of these vertices (the count: after all), as
//! every finite element deck has some; `places` ascending.
inline Renumbered with_unused_nodes(const mesh::TriangleMesh& mesh, const std::vector<int>& places)
{
    const int count = mesh.vertex_count(), unused = static_cast<int>(places.size());
    Points points = Points::Zero(count + unused, 3);
    for (int k = 0; k < unused; ++k)
        points.row(places[k] + k) =
            mesh.points().colwise().mean() + Eigen::RowVector3d(1.0, 2.0, 7.0);
    VertexIds new_id(count);
    for (int i = 0; i < count; ++i)
    {
        new_id[i] =
            i
            + static_cast<int>(std::upper_bound(places.begin(), places.end(), i) - places.begin());
        points.row(new_id[i]) = mesh.points().row(i);
    }
    Triangles triangles = mesh.triangles().unaryExpr([&](int id) { return new_id[id]; });
    return {mesh::TriangleMesh(std::move(points), std::move(triangles)), new_id};
}

//! Where unused nodes may stand: first, amid, last, and everywhere.
inline std::vector<std::vector<int>> unused_places(const mesh::TriangleMesh& mesh)
{
    const int count = mesh.vertex_count();
    return {{0}, {count / 2}, {count}, {0, 0, count / 3, count / 2, count, count}};
}

}  // namespace sheetmorph::shapes

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/submesh.h"

#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>

namespace sheetmorph::mesh
{

Submesh submesh(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
    Submesh part;
    part.vertices.reserve(3 * triangles.size());
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
            part.vertices.push_back(mesh.triangles()(t, k));
    make_set(part.vertices);
    part.index_of.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (std::size_t k = 0; k < part.vertices.size(); ++k)
        part.index_of[static_cast<std::size_t>(part.vertices[k])] = static_cast<int>(k);
    const Triangles corners = mesh.triangles()(triangles, Eigen::indexing::all);
    part.mesh =
        TriangleMesh(mesh.points()(part.vertices, Eigen::indexing::all),
                     corners.unaryExpr([&](int v) -> int
                                       { return part.index_of[static_cast<std::size_t>(v)]; }));
    return part;
}

}  // namespace sheetmorph::mesh

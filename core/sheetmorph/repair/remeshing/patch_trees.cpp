// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/patch_trees.h"

#include <algorithm>
#include <utility>

namespace sheetmorph::repair
{

namespace
{

mesh::TriangleMesh part_of(const mesh::TriangleMesh& mesh, const std::vector<int>& triangles)
{
    VertexIds vertices;
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
            vertices.push_back(mesh.triangles()(t, k));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    Triangles corners(triangles.size(), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            corners(t, k) = static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(),
                                                              mesh.triangles()(triangles[t], k))
                                             - vertices.begin());
    return mesh::TriangleMesh(mesh.points()(vertices, Eigen::indexing::all), std::move(corners));
}

}  // namespace

PatchTrees::PatchTrees(const mesh::TriangleMesh& mesh, const std::vector<int>& patch)
    : triangles_(patch.empty() ? 0 : 1 + *std::max_element(patch.begin(), patch.end()))
{
    for (std::size_t t = 0; t < patch.size(); ++t)
        triangles_[patch[t]].push_back(static_cast<int>(t));
    for (const std::vector<int>& triangles : triangles_)
        trees_.emplace_back(part_of(mesh, triangles));
}

mesh::Hit PatchTrees::nearest(int patch, const Vector3& point) const
{
    mesh::Hit hit = *trees_[patch].nearest_point(point);
    hit.triangle = triangles_[patch][hit.triangle];
    return hit;
}

}  // namespace sheetmorph::repair

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/vertex_triangles.h"

#include "sheetmorph/base/vertex_sets.h"

namespace sheetmorph::mesh
{

VertexTriangles::VertexTriangles(const TriangleMesh& mesh)
    : starts_(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0),
      triangles_(static_cast<std::size_t>(mesh.triangles().size()))
{
    const Triangles& corners = mesh.triangles();
    for (Eigen::Index k = 0; k < corners.size(); ++k)
        ++starts_[corners.data()[k] + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i)
        starts_[i] += starts_[i - 1];
    std::vector<int> next = starts_;
    for (Eigen::Index k = 0; k < corners.size(); ++k)
        triangles_[next[corners.data()[k]]++] = static_cast<int>(k / 3);
}

std::vector<int> VertexTriangles::around(const VertexIds& vertices) const
{
    std::vector<int> found;
    for (const int vertex : vertices)
        found.insert(found.end(), at(vertex).begin(), at(vertex).end());
    make_set(found);
    return found;
}

}  // namespace sheetmorph::mesh

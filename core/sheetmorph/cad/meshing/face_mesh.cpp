// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/face_mesh.h"
#include "sheetmorph/base/errors.h"

#include <algorithm>

namespace sheetmorph::cad
{

namespace
{

mesh::TriangleMesh mesh_of(const std::vector<FaceVertex>& vertices,
                           const std::vector<std::array<int, 3>>& triangles)
{
    Points points(static_cast<Eigen::Index>(vertices.size()), 3);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        points.row(static_cast<Eigen::Index>(i)) = vertices[i].point.transpose();
    Triangles corners(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        corners.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1],
            triangles[t][2];
    return mesh::TriangleMesh(std::move(points), std::move(corners));
}

std::vector<std::pair<int, int>> sorted(std::vector<std::pair<int, int>> sides)
{
    for (auto& [a, b] : sides)
        if (b < a)
            std::swap(a, b);
    std::sort(sides.begin(), sides.end());
    return sides;
}

}  // namespace

FaceMesh::FaceMesh(std::vector<FaceVertex> vertices,
                   const std::vector<std::array<int, 3>>& triangles,
                   std::vector<std::pair<int, int>> locked)
    : mesh::EditableTriangles(mesh_of(vertices, triangles), sorted(std::move(locked))),
      vertices_(std::move(vertices))
{
    if (has_clash())
        throw InvalidInput("two triangles of a face have the same side");
}

int FaceMesh::split(int t, int k, const FaceVertex& middle)
{
    vertices_.push_back(middle);
    return EditableTriangles::split(t, k);
}

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/patch_anchors.h"

#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/search/picking.h"

#include <limits>

namespace sheetmorph
{

namespace
{

Triangles triangles_inside(const TriangleMesh& mesh, const VertexIds& region)
{
    std::vector<char> inside(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (const int vertex : region)
        inside[static_cast<std::size_t>(vertex)] = 1;
    Triangles found(mesh.triangle_count(), 3);
    Eigen::Index count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        bool whole = true;
        for (int k = 0; k < 3; ++k)
            whole = whole && inside[static_cast<std::size_t>(mesh.triangles()(t, k))];
        if (whole)
            found.row(count++) = mesh.triangles().row(t);
    }
    return found.topRows(count);
}

PatchAnchor nearest_vertex(const TriangleMesh& mesh, const VertexIds& region, const Vector3& point)
{
    int nearest = region.front();
    double shortest = std::numeric_limits<double>::infinity();
    for (const int vertex : region)
    {
        const double distance = (mesh.points().row(vertex).transpose() - point).squaredNorm();
        if (distance < shortest)
        {
            shortest = distance;
            nearest = vertex;
        }
    }
    return {{nearest, nearest, nearest}, Vector3::UnitX()};
}

}  // namespace

Vector3 PatchAnchor::on(const Points& points) const
{
    Vector3 point = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        point += weights(static_cast<Eigen::Index>(k)) * points.row(corners[k]).transpose();
    return point;
}

std::vector<PatchAnchor> nearest_anchors(const TriangleMesh& mesh, const VertexIds& region,
                                         const Points& targets)
{
    std::vector<PatchAnchor> anchors;
    const TriangleMesh patch(mesh.points(), triangles_inside(mesh, region));
    const PickingTree tree(patch);
    for (Eigen::Index row = 0; row < targets.rows(); ++row)
    {
        const Vector3 point = targets.row(row).transpose();
        const std::optional<Hit> hit =
            patch.triangle_count() > 0 ? tree.nearest_point(point) : std::nullopt;
        if (!hit)
        {
            anchors.push_back(nearest_vertex(mesh, region, point));
            continue;
        }
        const auto corners = patch.triangles().row(hit->triangle);
        anchors.push_back({{corners(0), corners(1), corners(2)}, hit->barycentric});
    }
    return anchors;
}

VertexIds with_triangles_below(const TriangleMesh& mesh, const VertexIds& region,
                               const Points& targets)
{
    const PickingTree tree(mesh);
    VertexIds corners;
    for (Eigen::Index row = 0; row < targets.rows(); ++row)
        if (const std::optional<Hit> hit = tree.nearest_point(targets.row(row).transpose()))
            for (int k = 0; k < 3; ++k)
                corners.push_back(mesh.triangles()(hit->triangle, k));
    VertexIds wide = region;
    merge_into(wide, corners);
    return wide;
}

}  // namespace sheetmorph

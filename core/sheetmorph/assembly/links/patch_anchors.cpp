// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/patch_anchors.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/submesh.h"

#include <limits>

namespace sheetmorph
{

namespace
{

// The triangles with all corners in the region.
std::vector<int> triangles_inside(const TriangleMesh& mesh, const VertexIds& region)
{
    std::vector<char> inside(at(mesh.vertex_count()), 0);
    for (const int vertex : region)
        inside[at(vertex)] = 1;
    std::vector<int> found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const auto corners = mesh.triangles().row(t);
        if (inside[at(corners(0))] && inside[at(corners(1))] && inside[at(corners(2))])
            found.push_back(t);
    }
    return found;
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
    const Submesh patch = submesh(mesh, triangles_inside(mesh, region));
    const PickingTree tree(patch.mesh);
    for (Eigen::Index row = 0; row < targets.rows(); ++row)
    {
        const Vector3 point = targets.row(row).transpose();
        const std::optional<Hit> hit =
            patch.mesh.triangle_count() > 0 ? tree.nearest_point(point) : std::nullopt;
        if (!hit)
        {
            anchors.push_back(nearest_vertex(mesh, region, point));
            continue;
        }
        PatchAnchor anchor{{}, hit->barycentric};
        for (int k = 0; k < 3; ++k)
            anchor.corners[at(k)] = patch.vertices[at(patch.mesh.triangles()(hit->triangle, k))];
        anchors.push_back(anchor);
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

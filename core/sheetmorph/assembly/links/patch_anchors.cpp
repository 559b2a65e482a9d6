// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/patch_anchors.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>
#include <limits>

namespace sheetmorph::assembly
{

namespace
{

// The triangles with all corners in the region.
std::vector<int> triangles_inside(const mesh::PartGeometry& part, VertexIds region)
{
    make_set(region);
    std::vector<int> found;
    for (const int t : part.triangles().around(region))
    {
        const auto corners = part.mesh().triangles().row(t);
        if (std::all_of(corners.begin(), corners.end(),
                        [&](int corner)
                        { return std::binary_search(region.begin(), region.end(), corner); }))
            found.push_back(t);
    }
    return found;
}

mesh::Anchor nearest_vertex(const mesh::TriangleMesh& mesh, const VertexIds& region,
                            const Vector3& point)
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
    return mesh::Anchor::at_vertex(nearest);
}

}  // namespace

std::vector<mesh::Anchor> nearest_anchors(const mesh::PartGeometry& part, const VertexIds& region,
                                          const Points& targets)
{
    std::vector<mesh::Anchor> anchors;
    const mesh::Submesh patch = mesh::submesh(part.mesh(), triangles_inside(part, region));
    const mesh::PickingTree tree(patch.mesh);
    for (Eigen::Index row = 0; row < targets.rows(); ++row)
    {
        const Vector3 point = targets.row(row).transpose();
        const std::optional<mesh::Hit> hit =
            patch.mesh.triangle_count() > 0 ? tree.nearest_point(point) : std::nullopt;
        anchors.push_back(hit ? mesh::Anchor::at(*hit, patch.mesh.triangles())
                              : nearest_vertex(part.mesh(), region, point));
        for (int& corner : anchors.back().corners)
            if (hit)
                corner = patch.vertices[at(corner)];
    }
    return anchors;
}

bool has_triangles(const mesh::PartGeometry& part, const VertexIds& region)
{
    return !triangles_inside(part, region).empty();
}

VertexIds with_triangles_below(const mesh::PartGeometry& part, const VertexIds& region,
                               const Points& targets)
{
    VertexIds corners;
    for (Eigen::Index row = 0; row < targets.rows(); ++row)
        if (const std::optional<mesh::Hit> hit =
                part.tree().nearest_point(targets.row(row).transpose()))
            for (int k = 0; k < 3; ++k)
                corners.push_back(part.mesh().triangles()(hit->triangle, k));
    VertexIds wide = region;
    merge_into(wide, corners);
    return wide;
}

}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/followers.h"

#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/search/picking.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// The triangles that a vertex may follow: none with a corner that follows itself.
std::vector<int> leading_triangles(const TriangleMesh& rest, const VertexRoles& roles)
{
    std::vector<int> leading;
    for (int t = 0; t < rest.triangle_count(); ++t)
    {
        const auto corners = rest.triangles().row(t);
        if (std::none_of(corners.begin(), corners.end(),
                         [&](int corner) {
                             return roles.role[static_cast<std::size_t>(corner)] == Role::follower;
                         }))
            leading.push_back(t);
    }
    return leading;
}

}  // namespace

Followers::Followers(const TriangleMesh& rest, const VertexRoles& roles)
{
    if (std::find(roles.role.begin(), roles.role.end(), Role::follower) == roles.role.end())
        return;
    const std::vector<int> leading = leading_triangles(rest, roles);
    const PickingTree tree(TriangleMesh(rest.points(), rest.triangles()(leading, Eigen::all)));
    for (int i = 0; i < rest.vertex_count(); ++i)
        if (roles.role[static_cast<std::size_t>(i)] == Role::follower)
        {
            const std::optional<Hit> nearest = tree.nearest_point(rest.points().row(i).transpose());
            if (nearest)
                anchors_.push_back({i, leading[static_cast<std::size_t>(nearest->triangle)],
                                    nearest->barycentric});
        }
}

VertexIds Followers::corners(const TriangleMesh& rest) const
{
    VertexIds corners;
    for (const Anchor& anchor : anchors_)
        for (int k = 0; k < 3; ++k)
            corners.push_back(rest.triangles()(anchor.triangle, k));
    make_set(corners);
    return corners;
}

void Followers::place(const TriangleMesh& rest, Points& positions, Points& rotation_logs) const
{
    for (const Anchor& anchor : anchors_)
    {
        Vector3 position = Vector3::Zero();
        Vector3 log = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
        {
            const int corner = rest.triangles()(anchor.triangle, k);
            const Vector3 arm =
                (rest.points().row(anchor.vertex) - rest.points().row(corner)).transpose();
            const Vector3 corner_log = rotation_logs.row(corner).transpose();
            const Vector3 carried =
                positions.row(corner).transpose() + rotation_from_log(corner_log) * arm;
            position += anchor.barycentric(k) * carried;
            log += anchor.barycentric(k) * corner_log;
        }
        positions.row(anchor.vertex) = position.transpose();
        rotation_logs.row(anchor.vertex) = log.transpose();
    }
}

}  // namespace sheetmorph

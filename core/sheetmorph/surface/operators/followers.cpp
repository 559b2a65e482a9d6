// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/followers.h"

#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/search/picking.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// The triangles that a vertex may follow: those without a follower.
std::vector<int> leading_triangles(const mesh::TriangleMesh& rest, const VertexRoles& roles)
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

Followers::Followers(const mesh::TriangleMesh& rest, const VertexRoles& roles) : ties_(roles.ties)
{
    if (std::find(roles.role.begin(), roles.role.end(), Role::follower) == roles.role.end())
        return;
    const std::vector<int> leading = leading_triangles(rest, roles);
    const Triangles triangles = rest.triangles()(leading, Eigen::indexing::all);
    const mesh::PickingTree tree(mesh::TriangleMesh(rest.points(), triangles));
    for (int i = 0; i < rest.vertex_count(); ++i)
        if (roles.role[static_cast<std::size_t>(i)] == Role::follower)
            if (const auto nearest = tree.nearest_point(rest.points().row(i).transpose()))
                followers_.push_back({i, mesh::Anchor::at(*nearest, triangles)});
}

VertexIds Followers::corners() const
{
    VertexIds corners;
    for (const Tie& tie : ties_)
        corners.insert(corners.end(), tie.place.corners.begin(), tie.place.corners.end());
    for (const Follower& follower : followers_)
        corners.insert(corners.end(), follower.anchor.corners.begin(),
                       follower.anchor.corners.end());
    make_set(corners);
    return corners;
}

void Followers::place(const mesh::TriangleMesh& rest, Points& positions,
                      Points& rotation_logs) const
{
    for (const auto& [vertex, place] : ties_)
    {
        const Vector3 arm = rest.points().row(vertex).transpose() - place.on(rest.points());
        const Vector3 log = place.on(rotation_logs);
        // Computed as a displacement, so that a sheet at rest stays exactly at rest.
        const Vector3 shift = place.sum(
            [&](int corner) { return Vector3(positions.row(corner) - rest.points().row(corner)); });
        positions.row(vertex) =
            rest.points().row(vertex) + (shift + rotation_from_log(log) * arm - arm).transpose();
        rotation_logs.row(vertex) = log.transpose();
    }
    for (const auto& [vertex, anchor] : followers_)
    {
        const Vector3 own = rest.points().row(vertex).transpose();
        const auto carried = [&](int corner)
        {
            const Vector3 arm = own - rest.points().row(corner).transpose();
            const Vector3 log = rotation_logs.row(corner).transpose();
            return Vector3(positions.row(corner).transpose() + rotation_from_log(log) * arm);
        };
        positions.row(vertex) = anchor.sum(carried).transpose();
        rotation_logs.row(vertex) = anchor.on(rotation_logs).transpose();
    }
}

}  // namespace sheetmorph::surface

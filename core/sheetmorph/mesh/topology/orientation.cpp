// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/orientation.h"

#include <Eigen/Geometry>
#include <utility>

namespace sheetmorph
{

namespace
{

// Turns the triangles of one piece alike, beginning at `seed`; returns them.
std::vector<int> orient_piece(const EdgeTable& table, int seed, Orientation& orientation)
{
    std::vector<int> piece{seed};
    orientation.sign[seed] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next)
        for (int k = 0; k < 3; ++k)
        {
            const int edge = table.edge_of(piece[next], k);
            if (edge < 0 || table.uses(edge).count() != 2)
                continue;
            const EdgeUse& one = *table.uses(edge).begin();
            const EdgeUse& two = *(table.uses(edge).begin() + 1);
            const int other = one.triangle == piece[next] ? two.triangle : one.triangle;
            const int wanted = orientation.sign[piece[next]] * (one.from == two.from ? -1 : 1);
            if (orientation.sign[other] == 0)
            {
                orientation.sign[other] = wanted;
                piece.push_back(other);
            }
            else if (orientation.sign[other] != wanted)
                orientation.is_possible = false;
        }
    return piece;
}

}  // namespace

Orientation consistent_orientation(const TriangleMesh& mesh, const EdgeTable& table)
{
    Orientation orientation;
    orientation.sign.assign(static_cast<std::size_t>(mesh.triangle_count()), 0);
    for (int seed = 0; seed < mesh.triangle_count(); ++seed)
    {
        if (orientation.sign[seed] != 0)
            continue;
        const std::vector<int> piece = orient_piece(table, seed, orientation);
        std::size_t turned = 0;
        for (const int t : piece)
            turned += orientation.sign[t] < 0;
        if (2 * turned > piece.size())
            for (const int t : piece)
                orientation.sign[t] = -orientation.sign[t];
    }
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (orientation.sign[t] < 0)
            orientation.flipped.push_back(t);
    return orientation;
}

TriangleMesh oriented(const TriangleMesh& mesh, const Orientation& orientation)
{
    Triangles triangles = mesh.triangles();
    for (const int t : orientation.flipped)
        std::swap(triangles(t, 1), triangles(t, 2));
    return TriangleMesh(mesh.points(), std::move(triangles));
}

double signed_volume(const TriangleMesh& mesh, const std::vector<int>& triangles,
                     const std::vector<int>& sign)
{
    if (triangles.empty())
        return 0.0;
    const Points& points = mesh.points();
    const Vector3 origin = points.row(mesh.triangles()(triangles.front(), 0));
    double volume = 0.0;
    for (const int t : triangles)
    {
        const auto corner = [&](int k) -> Vector3
        { return points.row(mesh.triangles()(t, k)).transpose() - origin; };
        volume += sign[t] * corner(0).dot(corner(1).cross(corner(2))) / 6.0;
    }
    return volume;
}

}  // namespace sheetmorph

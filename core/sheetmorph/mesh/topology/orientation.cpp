// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/orientation.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/disjoint_sets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sheetmorph::mesh
{

namespace
{

// Half of the full solid angle 4 pi; a larger angle means inside. From geometry: a point outside
// has the angle 0, a point inside 4 pi.
constexpr double half_turn_of_space = 2.0 * pi;

// Orients the triangles of one piece like `seed`. Returns the piece.
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

// The triangles of every piece without an open edge, connected across edges of two triangles.
std::vector<std::vector<int>> closed_pieces(const TriangleMesh& mesh, const EdgeTable& table)
{
    DisjointSets sets(mesh.triangle_count());
    std::vector<int> open;
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const EdgeUses uses = table.uses(edge);
        if (uses.count() == 2)
            sets.join(uses.begin()->triangle, (uses.begin() + 1)->triangle);
        if (uses.count() == 1)
            open.push_back(uses.begin()->triangle);
    }
    std::map<int, std::vector<int>> pieces;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (table.edge_of(t, 0) >= 0)
            pieces[sets.root(t)].push_back(t);
    for (const int t : open)
        pieces.erase(sets.root(t));
    std::vector<std::vector<int>> found;
    for (auto& [root, triangles] : pieces)
        found.push_back(std::move(triangles));
    return found;
}

using Box = std::pair<Vector3, Vector3>;

Box box_of(const TriangleMesh& mesh, const std::vector<int>& piece)
{
    Box box{mesh.points().row(mesh.triangles()(piece.front(), 0)).transpose(), {}};
    box.second = box.first;
    for (const int t : piece)
        for (int k = 0; k < 3; ++k)
        {
            const Vector3 corner = mesh.points().row(mesh.triangles()(t, k)).transpose();
            box.first = box.first.cwiseMin(corner);
            box.second = box.second.cwiseMax(corner);
        }
    return box;
}

bool is_inside(const Box& box, const Box& other)
{
    return (box.first.array() > other.first.array()).all()
           && (box.second.array() < other.second.array()).all();
}

// Whether a closed piece winds around a point (Van Oosterom and Strackee 1983).
bool winds_around(const TriangleMesh& mesh, const std::vector<int>& piece,
                  const std::vector<int>& sign, const Vector3& point)
{
    double angle = 0.0;
    for (const int t : piece)
    {
        const auto corner = [&](int k) -> Vector3
        { return mesh.points().row(mesh.triangles()(t, k)).transpose() - point; };
        const Vector3 a = corner(0), b = corner(1), c = corner(2);
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += sign[t] * 2.0
                 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return std::abs(angle) > half_turn_of_space;
}

}  // namespace

Orientation outward_orientation(const TriangleMesh& mesh, const EdgeTable& table)
{
    Orientation orientation = consistent_orientation(mesh, table);
    if (!orientation.is_possible)
        return orientation;
    const std::vector<std::vector<int>> pieces = closed_pieces(mesh, table);
    for (const std::vector<int>& piece : pieces)
    {
        if (!(signed_volume(mesh, piece, orientation.sign) < 0.0))
            continue;
        const Vector3 place = mesh.points().row(mesh.triangles()(piece.front(), 0)).transpose();
        const Box box = box_of(mesh, piece);
        const auto encloses = [&](const std::vector<int>& other)
        {
            return is_inside(box, box_of(mesh, other))
                   && winds_around(mesh, other, orientation.sign, place);
        };
        const bool is_enclosed = std::any_of(pieces.begin(), pieces.end(), encloses);
        for (const int t : is_enclosed ? std::vector<int>() : piece)
            orientation.sign[t] = -orientation.sign[t];
    }
    orientation.flipped.clear();
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (orientation.sign[t] < 0)
            orientation.flipped.push_back(t);
    return orientation;
}

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

}  // namespace sheetmorph::mesh

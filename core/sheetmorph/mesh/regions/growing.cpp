// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/regions/growing.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/geometry/areas.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/regions/flags.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

namespace sheetmorph::mesh
{

namespace
{

constexpr int none = -1;

// Flags every vertex that shares a triangle with a flagged one, `rings` times.
void spread(const TriangleMesh& mesh, Flags& flags, int rings)
{
    if (rings < 0)
        throw InvalidInput("the number of rings is " + std::to_string(rings),
                           "it must be 0 or more");
    bool has_grown = true;
    for (int ring = 0; ring < rings && has_grown; ++ring)
    {
        has_grown = false;
        const Flags before = flags;
        for (int t = 0; t < mesh.triangle_count(); ++t)
        {
            const auto corners = mesh.triangles().row(t);
            if (!before[corners(0)] && !before[corners(1)] && !before[corners(2)])
                continue;
            for (int k = 0; k < 3; ++k)
            {
                has_grown = has_grown || !flags[corners(k)];
                flags[corners(k)] = 1;
            }
        }
    }
}

// The flood fill of grow_to_creases(). Each reached triangle has a plane. A degenerate triangle
// inherits the plane of the triangle from which it was reached.
class CreaseFlood
{
public:
    CreaseFlood(const TriangleMesh& mesh, const EdgeTable& table, double max_angle)
        : mesh_(mesh),
          table_(table),
          max_angle_(max_angle),
          is_reached_(static_cast<std::size_t>(mesh.triangle_count()), 0),
          plane_(static_cast<std::size_t>(mesh.triangle_count()), none)
    {
    }

    std::vector<int> from(int triangle)
    {
        reach(triangle, none);
        for (std::size_t next = 0; next < front_.size(); ++next)
            for (int k = 0; k < 3; ++k)
                if (const int edge = table_.edge_of(front_[next], k); edge != none)
                    cross(front_[next], edge);
        return ids_of(is_reached_);
    }

private:
    void reach(int triangle, int from)
    {
        is_reached_[triangle] = 1;
        plane_[triangle] = is_thin(mesh_.points(), mesh_.triangles(), triangle) ? from : triangle;
        front_.push_back(triangle);
    }

    void cross(int triangle, int edge)
    {
        const EdgeUse* here = nullptr;
        for (const EdgeUse& use : table_.uses(edge))
            if (use.triangle == triangle)
                here = &use;
        for (const EdgeUse& there : table_.uses(edge))
            if (!is_reached_[there.triangle] && bend(*here, there) < max_angle_)
                reach(there.triangle, plane_[triangle]);
    }

    double bend(const EdgeUse& here, const EdgeUse& there) const
    {
        const int plane = plane_[here.triangle];
        if (plane == none || is_thin(mesh_.points(), mesh_.triangles(), there.triangle))
            return 0.0;
        if (plane == here.triangle)
            return bend_angle(mesh_.points(), here, there);
        const Vector3 one = normal(plane);
        const Vector3 other = normal(there.triangle);
        return std::atan2(one.cross(other).norm(), std::abs(one.dot(other)));
    }

    Vector3 normal(int triangle) const { return doubled_area(mesh_, triangle).normalized(); }

    const TriangleMesh& mesh_;
    const EdgeTable& table_;
    double max_angle_;
    Flags is_reached_;
    std::vector<int> plane_;
    std::vector<int> front_;
};

}  // namespace

VertexIds grow_rings(const TriangleMesh& mesh, const VertexIds& vertices, int rings)
{
    Flags inside = flags_of(vertices, mesh.vertex_count(), "vertices");
    spread(mesh, inside, rings);
    return ids_of(inside);
}

VertexIds shrink_rings(const TriangleMesh& mesh, const VertexIds& vertices, int rings)
{
    Flags outside = flags_of(vertices, mesh.vertex_count(), "vertices");
    for (char& flag : outside)
        flag = !flag;
    spread(mesh, outside, rings);
    return ids_of(outside, 0);
}

std::vector<int> grow_to_creases(const TriangleMesh& mesh, int triangle, double max_angle)
{
    return grow_to_creases(mesh, EdgeTable(mesh), triangle, max_angle);
}

std::vector<int> grow_to_creases(const TriangleMesh& mesh, const EdgeTable& table, int triangle,
                                 double max_angle)
{
    flags_of({triangle}, mesh.triangle_count(), "triangles");
    if (!std::isfinite(max_angle))
        throw InvalidInput("the angle of a crease must be a finite number of radians");
    return CreaseFlood(mesh, table, max_angle).from(triangle);
}

std::vector<int> connected_triangles(const TriangleMesh& mesh, int triangle)
{
    Flags connected = flags_of({triangle}, mesh.triangle_count(), "triangles");
    DisjointSets sets(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 1; k < 3; ++k)
            sets.join(mesh.triangles()(t, 0), mesh.triangles()(t, k));
    const int root = sets.root(mesh.triangles()(triangle, 0));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        connected[t] = sets.root(mesh.triangles()(t, 0)) == root;
    return ids_of(connected);
}

std::vector<int> triangles_with_all_vertices(const TriangleMesh& mesh, const VertexIds& vertices)
{
    const Flags inside = flags_of(vertices, mesh.vertex_count(), "vertices");
    std::vector<int> found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const auto corners = mesh.triangles().row(t);
        if (inside[corners(0)] && inside[corners(1)] && inside[corners(2)])
            found.push_back(t);
    }
    return found;
}

VertexIds vertices_of_triangles(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
    flags_of(triangles, mesh.triangle_count(), "triangles");
    Flags corners(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
            corners[mesh.triangles()(t, k)] = 1;
    return ids_of(corners);
}

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/round_rims.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/mesh/regions/crease_loops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace sheetmorph::repair
{

namespace
{

constexpr double rim_angle = 0.7;   // radians, from mesh/quality/diagnosis.cpp
constexpr double roundness = 0.02;  // tolerance of round_rim(), from there

// Of a rim. From geometry: segments of 10 degrees deviate from the arc by 0.4 % of the radius.
constexpr double fewest_segments = 36.0;

Vector3 on_circle(const fitting::CircleFit& circle, const Vector3& place)
{
    Vector3 arm = place - circle.centre;
    arm -= circle.axis * circle.axis.dot(arm);
    return circle.centre + circle.radius * arm.normalized();
}

}  // namespace

RoundRims::RoundRims(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table)
{
    for (const VertexIds& loop : mesh::crease_loops(mesh, table, rim_angle))
    {
        const auto circle =
            fitting::round_rim(mesh.points()(loop, Eigen::indexing::all), roundness);
        if (!circle)
            continue;
        for (std::size_t k = 0; k < loop.size(); ++k)
        {
            const int here = loop[k], next = loop[(k + 1) % loop.size()];
            circle_of_[here] = count();
            circle_of_edge_[{std::min(here, next), std::max(here, next)}] = count();
        }
        circles_.push_back(*circle);
    }
}

std::vector<double> RoundRims::sizes(int count) const
{
    std::vector<double> found(static_cast<std::size_t>(count),
                              std::numeric_limits<double>::infinity());
    for (const auto& [vertex, circle] : circle_of_)
        found[vertex] = 2.0 * pi * circles_[circle].radius / fewest_segments;
    return found;
}

mesh::TriangleMesh RoundRims::rounded(int old_count, const CutMesh& cut) const
{
    Points points = cut.mesh.points();
    const auto move = [&](int vertex, int circle)
    { points.row(vertex) = on_circle(circles_[circle], points.row(vertex)).transpose(); };
    for (std::size_t k = 0; k < cut.places.size(); ++k)
    {
        const EdgePlace& place = cut.places[k];
        const auto found = circle_of_edge_.find(std::minmax(place.from, place.to));
        if (found != circle_of_edge_.end())
            move(old_count + static_cast<int>(k), found->second);
    }
    for (const auto& [vertex, circle] : circle_of_)
        move(vertex, circle);
    return mesh::TriangleMesh(std::move(points), cut.mesh.triangles());
}

}  // namespace sheetmorph::repair

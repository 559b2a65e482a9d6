// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/hole_wall.h"

#include "sheetmorph/base/angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace sheetmorph::recognise
{

namespace
{

constexpr int none = -1;
// Distance by which the wall of a hole may lie outside the outline, in radii of a circle of equal
// area. Chosen: a wall or collar that leans by 14 degrees over a height of one radius (tan 14
// degrees = 0.25).
constexpr double slack = 0.25;

int shared_edge(const FacetGraph& graph, int triangle, int other)
{
    for (int k = 0; k < 3; ++k)
        if (graph.across(triangle, k) == other)
            return graph.edges().edge_of(triangle, k);
    return none;
}

Vector3 flattened(const Vector3& vector, const Vector3& normal)
{
    return vector - normal.dot(vector) * normal;
}

// Distance of a point from a polygon in the same plane; 0 inside.
double outside_distance(const std::vector<Vector3>& polygon, const Vector3& point,
                        const Vector3& normal)
{
    double turn = 0.0;
    double nearest = -1.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Vector3 a = polygon[i] - point;
        const Vector3 b = polygon[(i + 1) % polygon.size()] - point;
        turn += std::atan2(a.cross(b).dot(normal), a.dot(b));
        const Vector3 span = b - a;
        const double share =
            std::clamp(-a.dot(span) / std::max(span.squaredNorm(), 1e-300), 0.0, 1.0);
        const double distance = (a + share * span).norm();
        nearest = nearest < 0.0 ? distance : std::min(nearest, distance);
    }
    return std::abs(turn) > pi ? 0.0 : nearest;
}

}  // namespace

WallTracer::WallTracer(const FacetGraph& graph, const std::vector<int>& labels,
                       const std::vector<const RegionLoop*>& loops)
    : graph_(graph), labels_(labels)
{
    for (const RegionLoop* loop : loops)
        for (std::size_t i = 0; i < loop->triangles.size(); ++i)
            if (loop->across[i] != none)
                doors_.emplace(loop->triangles[i],
                               shared_edge(graph, loop->triangles[i], loop->across[i]));
}

HoleWall WallTracer::behind(const RegionLoop& loop) const
{
    HoleWall wall;
    std::set<int> reached;
    std::vector<int> front;
    const auto reach = [&](int triangle)
    {
        if (reached.insert(triangle).second)
            front.push_back(triangle);
    };
    for (const int triangle : loop.across)
        if (triangle != none && labels_[triangle] != loop.region)
            reach(triangle);
    while (!front.empty())
    {
        const int triangle = front.back();
        front.pop_back();
        for (int k = 0; k < 3; ++k)
        {
            const int other = graph_.across(triangle, k);
            const int edge = graph_.edges().edge_of(triangle, k);
            if (other == none)
                wall.is_open =
                    wall.is_open || (edge >= 0 && graph_.edges().uses(edge).count() == 1);
            else if (labels_[other] == loop.region || reached.count(other))
                continue;
            else if (doors_.count({other, edge}) || is_outside(loop, other))
                wall.leads_out = true;
            else
                reach(other);
        }
    }
    wall.triangles.assign(reached.begin(), reached.end());
    measure(loop, wall);
    return wall;
}

bool WallTracer::is_outside(const RegionLoop& loop, int triangle) const
{
    const double reach = std::sqrt(loop.area / pi) * slack;
    const Vector3 point = flattened(graph_.centroid(triangle) - loop.center, loop.normal);
    std::vector<Vector3> polygon;
    double farthest = 0.0;
    for (const int vertex : loop.vertices)
    {
        polygon.push_back(flattened(graph_.point(vertex) - loop.center, loop.normal));
        farthest = std::max(farthest, polygon.back().norm());
    }
    if (point.norm() > farthest + reach)
        return true;
    return outside_distance(polygon, point, loop.normal) > reach;
}

void WallTracer::measure(const RegionLoop& loop, HoleWall& wall) const
{
    for (const int triangle : wall.triangles)
    {
        wall.covered +=
            graph_.area(triangle) * std::abs(graph_.normal(triangle).dot(loop.normal)) / loop.area;
        for (int k = 0; k < 3; ++k)
        {
            const Vector3 corner = graph_.point(graph_.mesh().triangles()(triangle, k));
            const double height = (corner - loop.center).dot(loop.normal);
            if (std::abs(height) > std::abs(wall.height))
                wall.height = height;
        }
    }
}

}  // namespace sheetmorph::recognise

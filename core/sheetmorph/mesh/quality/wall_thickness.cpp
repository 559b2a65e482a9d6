// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/wall_thickness.h"

#include "sheetmorph/mesh/geometry/areas.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace sheetmorph
{

namespace
{

constexpr int most_samples = 600;

struct Place
{
    int triangle;
    Vector3 point;
    int sign;  // +1 where the triangle faces outwards
};

// The fractional part of k times an irrational number: evenly spread for any count.
double spread(int k, double irrational)
{
    const double turns = (k + 0.5) * irrational;
    return turns - std::floor(turns);
}

// Places evenly over the area of the triangles.
std::vector<Place> sample(const TriangleMesh& mesh, const std::vector<int>& triangles)
{
    double whole = 0.0;
    for (const int t : triangles)
        whole += doubled_area(mesh, t).norm();
    std::vector<Place> places;
    double passed = 0.0;
    for (const int t : triangles)
    {
        passed += doubled_area(mesh, t).norm();
        while (int(places.size()) < most_samples
               && (double(places.size()) + 0.5) * whole <= passed * most_samples)
        {
            const int k = static_cast<int>(places.size());
            const double root = std::sqrt(spread(k, 0.7548776662466927));
            const double turn = spread(k, 0.5698402909980532);
            const Vector3 weights(1.0 - root, root * (1.0 - turn), root * turn);
            const auto corners = mesh.points()(mesh.triangles().row(t), Eigen::indexing::all);
            places.push_back({t, corners.transpose() * weights, 1});
        }
    }
    return places;
}

// The way through the body to a facet that faces the other way, within 30 degrees.
std::optional<double> way_through(const TriangleMesh& mesh, const PickingTree& tree,
                                  const Place& place, double skip)
{
    const Vector3 inward = -place.sign * doubled_area(mesh, place.triangle).normalized();
    const std::optional<Hit> hit = tree.nearest_hit(place.point + skip * inward, inward);
    if (!hit || hit->triangle == place.triangle)
        return std::nullopt;
    const double alignment = doubled_area(mesh, hit->triangle).normalized().dot(inward);
    if (std::abs(alignment) < 0.866)
        return std::nullopt;
    return hit->distance + skip;
}

}  // namespace

WallThickness wall_thickness(const TriangleMesh& mesh, const PickingTree& tree,
                             const std::vector<int>& triangles, const std::vector<int>& sign)
{
    std::vector<Place> places = sample(mesh, triangles);
    // Far enough in to leave the facet itself behind, whatever the rounding.
    const double skip = 1e-9 * mesh.size() + exactness(mesh.points(), mesh.size());
    std::vector<double> ways;
    for (Place& place : places)
    {
        place.sign = sign[place.triangle];
        if (const auto way = way_through(mesh, tree, place, skip))
            ways.push_back(*way);
    }
    if (ways.empty())
        return {};
    std::sort(ways.begin(), ways.end());
    WallThickness found;
    found.median = ways[ways.size() / 2];
    const auto begin = std::lower_bound(ways.begin(), ways.end(), 0.5 * found.median);
    const auto end = std::upper_bound(begin, ways.end(), 1.5 * found.median);
    const auto near = static_cast<std::size_t>(end - begin);
    found.share = double(near) / double(places.size());
    found.low = *(begin + static_cast<std::ptrdiff_t>(near / 20));
    found.high = *(end - 1 - static_cast<std::ptrdiff_t>(near / 20));
    return found;
}

}  // namespace sheetmorph

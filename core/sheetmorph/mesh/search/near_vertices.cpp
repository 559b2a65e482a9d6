// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/near_vertices.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/search/point_grid.h"
#include "sheetmorph/mesh/topology/boundary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

namespace sheetmorph::mesh
{

namespace
{

// Decides which vertices may merge: those of the same piece, and any vertex at an open edge.
class Seams
{
public:
    explicit Seams(const TriangleMesh& mesh)
        : pieces_(mesh.vertex_count()), is_open_(static_cast<std::size_t>(mesh.vertex_count()), 0)
    {
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 1; k < 3; ++k)
                pieces_.join(mesh.triangles()(t, 0), mesh.triangles()(t, k));
        for (const BoundaryEdge& edge : boundary_edges(mesh))
            is_open_[edge.from] = is_open_[edge.to] = 1;
    }

    bool may_join(int a, int b)
    {
        return is_open_[a] || is_open_[b] || pieces_.root(a) == pieces_.root(b);
    }

private:
    DisjointSets pieces_;
    std::vector<char> is_open_;
};

}  // namespace

std::vector<std::pair<int, int>> near_pairs(const Points& points, double tolerance)
{
    if (!(tolerance >= 0.0) || !std::isfinite(tolerance))
        throw InvalidInput("the tolerance for near vertices is " + std::to_string(tolerance),
                           "give a length of 0 or more");
    if (points.rows() == 0)
        return {};
    const Vector3 extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).transpose();
    // With smaller cells, the cell indices would overflow.
    const double side = std::max({4.0 * tolerance, 1e-15 * extent.maxCoeff(), 1e-300});
    const PointGrid grid(points, side);
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < points.rows(); ++i)
    {
        const Vector3 place = points.row(i).transpose();
        grid.for_each_in(place.array() - tolerance, place.array() + tolerance,
                         [&](int j)
                         {
                             if (j > i && (points.row(j).transpose() - place).norm() <= tolerance)
                                 pairs.emplace_back(i, j);
                         });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

Weld weld(const TriangleMesh& mesh, double tolerance)
{
    const Points& points = mesh.points();
    Seams seams(mesh);
    // Sorts equal points first, because a mesh without shared vertices has many copies of each.
    std::vector<int> order(static_cast<std::size_t>(points.rows()));
    std::iota(order.begin(), order.end(), 0);
    const auto row = [&](int i) { return std::tuple(points(i, 0), points(i, 1), points(i, 2)); };
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return std::pair(row(a), a) < std::pair(row(b), b); });
    DisjointSets sets(static_cast<int>(points.rows()));
    std::vector<int> distinct;
    for (const int vertex : order)
        if (!distinct.empty() && row(distinct.back()) == row(vertex)
            && seams.may_join(distinct.back(), vertex))
            sets.join(distinct.back(), vertex);
        else
            distinct.push_back(vertex);
    Weld found;
    found.equal = static_cast<int>(order.size() - distinct.size());
    for (const auto& [a, b] : near_pairs(points(distinct, Eigen::indexing::all), tolerance))
        if (seams.may_join(distinct[a], distinct[b]))
        {
            sets.join(distinct[a], distinct[b]);
            ++found.near;
        }
    for (int i = 0; i < points.rows(); ++i)
        found.first.push_back(sets.root(i));
    return found;
}

}  // namespace sheetmorph::mesh

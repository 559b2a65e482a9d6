// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/near_vertices.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/topology/boundary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>

namespace sheetmorph
{

namespace
{

using Pairs = std::vector<std::pair<int, int>>;

std::uint64_t cell_of(const Vector3& place)
{
    std::uint64_t key = 0;
    for (int c = 0; c < 3; ++c)
        key = (key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(place(c)))))
              * 0x9e3779b97f4a7c15U;
    return key;
}

// Adds the pairs inside every run of equal cells. Cells are hashed: what only the hash brings
// together is sorted out by the distance.
void add_pairs(const std::vector<std::pair<std::uint64_t, int>>& cells, const Points& points,
               double tolerance, Pairs& pairs)
{
    for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end)
    {
        while (end < cells.size() && cells[end].first == cells[begin].first)
            ++end;
        for (std::size_t a = begin; a < end; ++a)
            for (std::size_t b = a + 1; b < end; ++b)
                if ((points.row(cells[a].second) - points.row(cells[b].second)).norm() <= tolerance)
                    pairs.emplace_back(cells[a].second, cells[b].second);
    }
}

// Which vertices may be one: those of one piece, and any at an open edge.
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

// Two near points lie in one cell of at least one of eight grids shifted by half a cell.
std::vector<std::pair<int, int>> near_pairs(const Points& points, double tolerance)
{
    if (!(tolerance >= 0.0) || !std::isfinite(tolerance))
        throw InvalidInput("the tolerance for near vertices is " + std::to_string(tolerance)
                           + "; give a length of 0 or more");
    if (points.rows() == 0)
        return {};
    const Vector3 low = points.colwise().minCoeff();
    const Vector3 extent = points.colwise().maxCoeff().transpose() - low;
    // Finer cells than this would not fit the numbers that count them.
    const double cell = std::max({4.0 * tolerance, 1e-15 * extent.maxCoeff(), 1e-300});
    std::vector<std::pair<std::uint64_t, int>> cells(static_cast<std::size_t>(points.rows()));
    Pairs pairs;
    for (int shift = 0; shift < 8; ++shift)
    {
        const Vector3 start(0.5 * (shift & 1), 0.5 * (shift >> 1 & 1), 0.5 * (shift >> 2 & 1));
        for (int i = 0; i < points.rows(); ++i)
            cells[i] = {cell_of((points.row(i).transpose() - low) / cell + start), i};
        std::sort(cells.begin(), cells.end());
        add_pairs(cells, points, tolerance, pairs);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

Weld weld(const TriangleMesh& mesh, double tolerance)
{
    const Points& points = mesh.points();
    Seams seams(mesh);
    // Equal points first, by sorting: a mesh without common vertices has many copies of each.
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
    for (const auto& [a, b] : near_pairs(points(distinct, Eigen::all), tolerance))
        if (seams.may_join(distinct[a], distinct[b]))
        {
            sets.join(distinct[a], distinct[b]);
            ++found.near;
        }
    for (int i = 0; i < points.rows(); ++i)
        found.first.push_back(sets.root(i));
    return found;
}

}  // namespace sheetmorph

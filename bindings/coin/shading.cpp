// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "sheetmorph/base/disjoint_sets.h"

namespace sheetmorph::coin
{

namespace
{

struct HalfEdge
{
    std::array<int, 2> ends;  // smaller vertex first
    int triangle;
};

// By smaller vertex, then by larger one: counted into place, then sorted among the few of a vertex.
std::vector<HalfEdge> sorted_half_edges(const Triangles& triangles, Eigen::Index vertex_count)
{
    std::vector<HalfEdge> edges(static_cast<std::size_t>(3 * triangles.rows()));
    std::vector<std::size_t> ends(static_cast<std::size_t>(vertex_count) + 1, 0);
    const auto smaller = [&](int t, int side)
    { return std::min(triangles(t, side), triangles(t, (side + 1) % 3)); };
    for (int t = 0; t < triangles.rows(); ++t)
        for (int side = 0; side < 3; ++side)
            ++ends[static_cast<std::size_t>(smaller(t, side)) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::size_t> next(ends);
    for (int t = 0; t < triangles.rows(); ++t)
        for (int side = 0; side < 3; ++side)
        {
            const int first = smaller(t, side);
            const int last = std::max(triangles(t, side), triangles(t, (side + 1) % 3));
            edges[next[static_cast<std::size_t>(first)]++] = {{first, last}, t};
        }
    for (std::size_t v = 0; v + 1 < ends.size(); ++v)
        std::sort(edges.begin() + static_cast<std::ptrdiff_t>(ends[v]),
                  edges.begin() + static_cast<std::ptrdiff_t>(ends[v + 1]),
                  [](const HalfEdge& a, const HalfEdge& b)
                  { return std::tie(a.ends[1], a.triangle) < std::tie(b.ends[1], b.triangle); });
    return edges;
}

Points face_normals(const Points& points, const Triangles& triangles)
{
    Points normals(triangles.rows(), 3);
    for (int t = 0; t < triangles.rows(); ++t)
    {
        const Vector3 a = points.row(triangles(t, 0));
        const Vector3 b = points.row(triangles(t, 1));
        const Vector3 c = points.row(triangles(t, 2));
        normals.row(t) = (b - a).cross(c - a).normalized().transpose();
    }
    return normals;
}

int corner_at(const Triangles& triangles, int triangle, int vertex)
{
    int corner = 0;
    while (triangles(triangle, corner) != vertex)
        ++corner;
    return 3 * triangle + corner;
}

}  // namespace

CornerNormals corner_normals(const Points& points, const Triangles& triangles, double crease)
{
    const std::vector<HalfEdge> edges = sorted_half_edges(triangles, points.rows());
    const Points normals = face_normals(points, triangles);
    const double smooth = std::cos(crease);
    DisjointSets corners(static_cast<int>(3 * triangles.rows()));
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    {
        const HalfEdge& a = edges[i];
        const HalfEdge& b = edges[i + 1];
        if (a.ends != b.ends || normals.row(a.triangle).dot(normals.row(b.triangle)) < smooth)
            continue;
        for (const int vertex : a.ends)
            corners.join(corner_at(triangles, a.triangle, vertex),
                         corner_at(triangles, b.triangle, vertex));
    }

    CornerNormals result;
    result.of_corner.resize(triangles.rows(), 3);
    std::vector<int> number(static_cast<std::size_t>(3 * triangles.rows()), -1);
    for (int corner = 0; corner < 3 * triangles.rows(); ++corner)
    {
        int& of_root = number[static_cast<std::size_t>(corners.root(corner))];
        if (of_root < 0)
            of_root = result.count++;
        result.of_corner(corner / 3, corner % 3) = of_root;
    }
    return result;
}

}  // namespace sheetmorph::coin

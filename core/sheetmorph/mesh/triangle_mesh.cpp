// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/triangle_mesh.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/limits.h"

#include <limits>
#include <utility>

namespace sheetmorph::mesh
{

namespace
{

void check_points(const Points& points)
{
    std::vector<int> bad;
    for (int i = 0; i < points.rows(); ++i)
        if (!are_numbers(points.row(i)))
            bad.push_back(i);
    if (!bad.empty())
        throw InvalidInput(
            "vertices with coordinates that are not finite numbers, or beyond 1e30 mm: "
                + Text::listed("", bad),
            "repair or remove them");
}

void check_triangles(const Triangles& triangles, int vertex_count)
{
    std::vector<int> bad;
    for (int t = 0; t < triangles.rows(); ++t)
        if (triangles.row(t).minCoeff() < 0 || triangles.row(t).maxCoeff() >= vertex_count)
            bad.push_back(t);
    if (!bad.empty())
        throw InvalidInput("triangles that name vertices outside 0.."
                           + std::to_string(vertex_count - 1) + ": " + list_ids(bad));
}

}  // namespace

TriangleMesh::TriangleMesh(Points points, Triangles triangles)
    : points_(std::move(points)), triangles_(std::move(triangles))
{
    check_points(points_);
    check_triangles(triangles_, vertex_count());
}

double TriangleMesh::size() const
{
    if (points_.rows() == 0)
        return 0.0;
    return (points_.colwise().maxCoeff() - points_.colwise().minCoeff()).norm();
}

double exactness(const Points& points, double size)
{
    const double largest = points.rows() ? points.cwiseAbs().maxCoeff() : 0.0;
    // Chosen: refined solves of a prototype were exact to 4e-14 of the size at 490,000 vertices.
    // Coordinates far from the origin are themselves exact to an epsilon, and a few operations add
    // to it.
    return 1e-12 * size + 8.0 * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace sheetmorph::mesh

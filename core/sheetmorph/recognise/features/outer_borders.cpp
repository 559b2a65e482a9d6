// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/outer_borders.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sheetmorph::recognise
{

namespace
{

// Radians. From geometry: above every bend (pi), so that regions are connected pieces.
constexpr double any_bend = 4.0;

// Minimum share of the enclosed area that a closing piece covers. Chosen: it closes the loop if
// most of it is covered.
constexpr double least_floor = 0.5;

// Steps along a loop. Chosen: the extent of a circle of 128 points is exact to 0.03 %.
constexpr std::size_t most_places = 128;

// Largest distance between two vertices, from a sample of up to 128 steps, mm.
double extent_of(const FacetGraph& graph, const RegionLoop& loop)
{
    const std::size_t step = std::max<std::size_t>(1, loop.vertices.size() / most_places);
    double extent = 0.0;
    for (std::size_t i = 0; i < loop.vertices.size(); i += step)
        for (std::size_t j = 0; j < i; j += step)
            extent = std::max(
                extent, (graph.point(loop.vertices[i]) - graph.point(loop.vertices[j])).norm());
    return extent;
}

using Polygon = Eigen::Matrix<double, Eigen::Dynamic, 2>;

bool is_inside(const Polygon& polygon, const Eigen::RowVector2d& place)
{
    bool inside = false;
    for (Eigen::Index i = 0, j = polygon.rows() - 1; i < polygon.rows(); j = i++)
    {
        const Eigen::RowVector2d a = polygon.row(i);
        const Eigen::RowVector2d b = polygon.row(j);
        if ((a.y() > place.y()) != (b.y() > place.y())
            && place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

}  // namespace

OuterBorders::OuterBorders(const FacetGraph& graph, const std::vector<RegionLoop>& free_loops)
    : graph_(graph), piece_(smooth_regions(graph, any_bend))
{
    for (const int piece : piece_)
        if (piece >= static_cast<int>(largest_.size()))
            largest_.resize(static_cast<std::size_t>(piece) + 1, 0.0);
    for (const RegionLoop& loop : free_loops)
        if (loop.is_free())
        {
            double& largest = largest_[piece_of(loop)];
            largest = std::max(largest, extent_of(graph, loop));
        }
}

bool OuterBorders::has(const RegionLoop& loop) const
{
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = loop.normal.unitOrthogonal();
    plane.col(1) = loop.normal.cross(plane.col(0));
    const Polygon outline = graph_.mesh().points()(loop.vertices, Eigen::indexing::all) * plane;
    double shown = 0.0;
    for (const int triangle : loop.triangles)
        shown += graph_.area(triangle) * graph_.normal(triangle).dot(loop.normal);
    const double side = shown < 0.0 ? -1.0 : 1.0;
    // Projected area of the piece inside the loop, and outside it with the side that the piece
    // shows at the loop, mm^2.
    double inside = 0.0, beside = 0.0;
    for (int t = 0; t < graph_.triangle_count(); ++t)
    {
        if (piece_[t] != piece_of(loop))
            continue;
        const double covered = graph_.area(t) * graph_.normal(t).dot(loop.normal);
        if (is_inside(outline, graph_.centroid(t).transpose() * plane))
            inside += std::abs(covered);
        else
            beside += std::max(0.0, side * covered);
        if (!(beside < loop.area))
            return false;  // early exit for holes in large sheets
    }
    const bool is_largest = loop.is_free() && extent_of(graph_, loop) >= largest_[piece_of(loop)];
    return is_largest || inside >= least_floor * loop.area;
}

}  // namespace sheetmorph::recognise

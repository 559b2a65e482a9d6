// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces/surface_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

using Row = Eigen::Matrix<double, 7, 1>;
using Normal = Eigen::Matrix<double, 7, 7>;

// How the offset of a place changes with the point (3), the tilt of the axis to two sides, the
// radius and the angle of a surface.
Row slope_at(const Surface& surface, const Vector3& place, const Vector3& u, const Vector3& v)
{
    const Vector3 off = place - surface.point;
    const double along = off.dot(surface.axis);
    const Vector3 flat = off - along * surface.axis;
    const double away = flat.norm();
    const Vector3 out = flat / std::max(away, 1e-300);
    Row slope = Row::Zero();
    slope.head<3>() = -surface.normal(place);
    if (surface.kind == FeatureKind::cone)
    {
        const double tilt = -along * std::cos(surface.angle) - away * std::sin(surface.angle);
        slope(3) = tilt * out.dot(u);
        slope(4) = tilt * out.dot(v);
        slope(6) = -away * std::sin(surface.angle) - along * std::cos(surface.angle);
        return slope;
    }
    slope(5) = -1.0;
    if (surface.kind == FeatureKind::cylinder)
    {
        slope(3) = -along * out.dot(u);
        slope(4) = -along * out.dot(v);
    }
    return slope;
}

Surface stepped(Surface surface, const Row& step, const Vector3& u, const Vector3& v)
{
    surface.point += step.head<3>();
    surface.axis = (surface.axis + step(3) * u + step(4) * v).normalized();
    surface.radius += step(5);
    surface.angle += step(6);
    return surface;
}

double squares_of(const Points& corners, const Surface& surface)
{
    double sum = 0.0;
    for (Eigen::Index i = 0; i < corners.rows(); ++i)
        sum += std::pow(surface.offset(corners.row(i).transpose()), 2);
    return sum;
}

// Corners of the triangles, of many triangles some.
Points corners_of(const FacetGraph& graph, const std::vector<int>& triangles)
{
    constexpr std::size_t most = 250;
    const std::size_t stride = 1 + triangles.size() / most;
    Points corners(3 * ((triangles.size() + stride - 1) / stride), 3);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < triangles.size(); i += stride)
        for (int k = 0; k < 3; ++k)
            corners.row(row++) = graph.point(graph.mesh().triangles()(triangles[i], k)).transpose();
    return corners;
}

}  // namespace

Surface refined(const FacetGraph& graph, const std::vector<int>& triangles, const Surface& start)
{
    // Each step that is taken lowers the squares, and what fits is judged by the triangles near it.
    constexpr int most_steps = 12;
    const Points corners = corners_of(graph, triangles);
    Surface best = start;
    double least = squares_of(corners, best);
    double damping = 1e-6;
    for (int step = 0; step < most_steps; ++step)
    {
        const Vector3 u = best.axis.unitOrthogonal();
        const Vector3 v = best.axis.cross(u);
        Normal normal = Normal::Zero();
        Row right = Row::Zero();
        for (Eigen::Index i = 0; i < corners.rows(); ++i)
        {
            const Vector3 corner = corners.row(i).transpose();
            const Row slope = slope_at(best, corner, u, v);
            normal.selfadjointView<Eigen::Lower>().rankUpdate(slope);
            right -= best.offset(corner) * slope;
        }
        normal = normal.selfadjointView<Eigen::Lower>();
        normal.diagonal() += damping * (normal.diagonal() + Row::Constant(1e-6 * normal.trace()));
        const Surface next = stepped(best, normal.ldlt().solve(right), u, v);
        const double squares = squares_of(corners, next);
        if (!(squares < least))
        {
            damping *= 100.0;
            continue;
        }
        const bool is_done = least - squares <= 1e-6 * least;
        best = next;
        least = squares;
        damping *= 0.1;
        if (is_done)
            break;
    }
    return best;
}

double misfit_of(const FacetGraph& graph, const std::vector<int>& triangles, const Surface& surface)
{
    double worst = 0.0;
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
        {
            const Vector3 corner = graph.point(graph.mesh().triangles()(t, k));
            const double radius = std::max(surface.radius_at(corner), 1e-300);
            worst = std::max(worst, surface.distance(corner) / radius);
        }
    return worst;
}

}  // namespace sheetmorph

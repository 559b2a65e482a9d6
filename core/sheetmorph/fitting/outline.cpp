// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/outline.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/fitting/stadium.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sheetmorph::fitting
{

namespace
{

using Corners = Eigen::Array<bool, Eigen::Dynamic, 1>;

// Enclosed area over squared radius of a circle's rim. From geometry: 2 for a square, 2.38 for a
// pentagon, 2.6 for a hexagon.
constexpr double least_round_area = 2.3;

// Edges tried as sides of the bounding rectangle, longest first. Chosen: a rim with more equal
// edges is round, so any of them will do.
constexpr std::size_t most_directions = 96;

// Length over width below which a slot counts as a circle. From least_tolerance: a circle fitted to
// this slot deviates by half the excess, 0.03 of the radius.
constexpr double shortest_slot = 1.06;

// Residual of a circle, relative to its radius, above which a rounded rectangle may replace it.
// Chosen above least_tolerance.
constexpr double barely_off = 0.04;

// Residual of that rectangle, relative to the circle's. Chosen: it has two more parameters and
// always fits better; a third shows that it is one.
constexpr double clearly_better = 0.35;

// Corner radius over half the width above which a rectangle counts as a slot. Chosen far above the
// corners of usual rectangles, and below a slot (1), whose coarse ends may fit a smaller radius.
// Measured: at 1.6 slots are lost (the same test as for most_missing_area).
constexpr double roundest_rectangle = 0.8;

// Deviation of a formed hole, relative to its radius, that is always allowed, however fine its
// polygon is. Chosen as the sagitta of a polygon of 13 corners. Measured: at 0.06 an oval counts as
// a hole (RimProfile.AnOvalIsNotFound).
constexpr double least_tolerance = 0.03;

// Smallest turn at a corner, relative to the mean turn of the rim's vertices. Chosen: vertices on
// chords turn by nothing, corners by the mean or more.
constexpr double least_turn = 0.5;

// Chosen: a rim with fewer corners is probably a polygon; then all its vertices count as corners.
constexpr Eigen::Index fewest_refined = 8;

// Fewest vertices at each end of a slot. From geometry: a rectangle has only its two corners there.
// Measured: with six, slots are lost (the same test as for most_missing_area).
constexpr Eigen::Index fewest_at_end = 3;

// Largest difference between the areas of the polygon and of the fitted outline, relative to the
// latter. From geometry: a polygon of seven corners on a circle lacks 0.129, one of six 0.173.
// Measured: at 0.07 coarse slots are lost (RimProfile.ASlotIsFoundExactlyWhereverItLies).
constexpr double most_missing_area = 0.14;

struct RoundedBox
{
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    Eigen::Vector2d along = Eigen::Vector2d::UnitX();
    Eigen::Vector2d half = Eigen::Vector2d::Zero();
    double radius = 0.0;
    double residual = 0.0;
};

double distance_to(const RoundedBox& box, const Eigen::Vector2d& point)
{
    const Eigen::Vector2d off = point - box.center;
    const Eigen::Vector2d place(std::abs(off.dot(box.along)),
                                std::abs(box.along.x() * off.y() - box.along.y() * off.x()));
    const Eigen::Vector2d out = place - (box.half.array() - box.radius).matrix();
    return out.cwiseMax(0.0).norm() + std::min(0.0, out.maxCoeff()) - box.radius;
}

double worst_miss(const PlanePoints& points, const RoundedBox& box)
{
    double worst = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        worst = std::max(worst, std::abs(distance_to(box, points.row(i).transpose())));
    return worst;
}

// The bounding rectangle of the points with sides along and across u (length 1).
RoundedBox rectangle_along(const PlanePoints& points, const Eigen::Vector2d& u)
{
    const Eigen::Vector2d v(-u.y(), u.x());
    const Eigen::VectorXd x = points * u;
    const Eigen::VectorXd y = points * v;
    const Eigen::Vector2d half(0.5 * (x.maxCoeff() - x.minCoeff()),
                               0.5 * (y.maxCoeff() - y.minCoeff()));
    RoundedBox box;
    box.center = 0.5 * (x.maxCoeff() + x.minCoeff()) * u + 0.5 * (y.maxCoeff() + y.minCoeff()) * v;
    box.along = half.x() >= half.y() ? u : v;
    box.half = half.x() >= half.y() ? half : Eigen::Vector2d(half.y(), half.x());
    return box;
}

// The bounding rectangle of smallest area that is parallel to an edge of the polygon.
RoundedBox smallest_rectangle(const PlanePoints& points)
{
    const std::size_t count = static_cast<std::size_t>(points.rows());
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto edge = [&](std::size_t i) -> Eigen::Vector2d
    { return (points.row((i + 1) % count) - points.row(i)).transpose(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return edge(a).squaredNorm() > edge(b).squaredNorm(); });
    order.resize(std::min(count, most_directions));
    RoundedBox best;
    double smallest = -1.0;
    for (const std::size_t i : order)
    {
        const RoundedBox box = rectangle_along(points, edge(i).normalized());
        if (smallest >= 0.0 && box.half.prod() >= smallest * (1.0 - 1e-9))
            continue;
        smallest = box.half.prod();
        best = box;
    }
    return best;
}

// The corner radius with the smallest residual, found by a coarse scan and three finer scans around
// the best value. They determine it to 1e-4 of the half width; the residual refers to the returned
// radius.
RoundedBox with_corners(const PlanePoints& points, RoundedBox box)
{
    double low = 0.0;
    double high = box.half.y();
    for (int round = 0; round < 4; ++round)
    {
        constexpr int steps = 16;  // from the precision: four rounds of 16 and 3 * 8 give 1e-4
        double best = low;
        double least = -1.0;
        for (int k = 0; k <= steps; ++k)
        {
            box.radius = low + (high - low) * k / steps;
            const double miss = worst_miss(points, box);
            if (least < 0.0 || miss < least)
            {
                least = miss;
                best = box.radius;
            }
        }
        const double step = (high - low) / steps;
        box.radius = best;
        box.residual = least;
        low = std::max(0.0, best - step);
        high = std::min(box.half.y(), best + step);
    }
    return box;
}

// If the ends of a slot have no vertices at their tips, no edge is parallel to its sides. The box
// is therefore rotated until it fits best.
RoundedBox rounded_box(const PlanePoints& points)
{
    RoundedBox best = with_corners(points, smallest_rectangle(points));
    // Chosen: 2.3 degrees, half the angle between two of 80 edges, then halved down to 1e-5 of the
    // length.
    for (double turn = 0.04; turn > 1e-5; turn *= 0.5)
        for (const double way : {turn, -turn})
        {
            const Eigen::Vector2d along = Eigen::Rotation2Dd(way) * best.along;
            const RoundedBox box = with_corners(points, rectangle_along(points, along));
            if (box.residual < best.residual)
                best = box;
        }
    return best;
}

// Tolerance of a fit: a share of the half width, plus an allowance for measurement noise.
struct Slack
{
    double form = 0.0;
    double scatter = 0.0;  // mm

    double at(double half) const { return form * half + added(half); }
    double added(double half) const { return std::min(three * scatter, most_scatter * half); }

    // Standard deviations; from the normal distribution: one point of 370 is farther.
    static constexpr double three = 3.0;
    // Chosen: with more than this share of the half width, a triangle would pass as a circle (its
    // points are between 0.5 and 1 radius away).
    static constexpr double most_scatter = 0.3;
};

double sagitta(Eigen::Index corners)
{
    return 1.0 - std::cos(pi / static_cast<double>(std::max<Eigen::Index>(corners, 3)));
}

double faceting_tolerance(Eigen::Index corners)
{
    return std::max(least_tolerance, sagitta(corners));
}

// Marks the vertices at which the loop turns. Mesh refinement puts others on the chords of a hole;
// they carry no information about its shape.
Corners corners_of(const PlanePoints& points)
{
    const Eigen::Index count = points.rows();
    const double least = least_turn * 2.0 * pi / static_cast<double>(count);
    Corners corners(count);
    for (Eigen::Index k = 0; k < count; ++k)
    {
        const Eigen::Vector2d in = points.row(k) - points.row((k + count - 1) % count);
        const Eigen::Vector2d out = points.row((k + 1) % count) - points.row(k);
        const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        corners(k) = std::abs(turn) >= least;
    }
    return corners.count() < fewest_refined ? Corners::Constant(count, true) : corners;
}

// Faceting makes a circle as uneven and as long as its polygon. Only a larger deviation makes it a
// slot.
bool is_round(const Outline& circle, const RoundedBox& box, const Slack& slack, Eigen::Index count)
{
    if (circle.residual > slack.at(circle.radius)
        || circle.area < least_round_area * circle.radius * circle.radius)
        return false;
    const double unsure = slack.added(circle.radius) + sagitta(count) * circle.radius;
    const bool is_off = box.half.x() > shortest_slot * box.half.y() + 2.0 * unsure
                        || circle.residual > barely_off * circle.radius + unsure;
    return !(is_off && box.residual < clearly_better * circle.residual);
}

bool is_slot(const RoundedBox& box)
{
    return box.radius >= roundest_rectangle * box.half.y();
}

// The vertices on the round ends of a slot, and the number of corners among them.
struct RoundEnds
{
    Eigen::Index left = 0;
    Eigen::Index right = 0;
    Eigen::Index corners = 0;

    RoundEnds(const PlanePoints& points, const RoundedBox& box)
    {
        const double straight = box.half.x() - box.half.y() - least_tolerance * box.half.y();
        const Eigen::ArrayXd along = (points.rowwise() - box.center.transpose()) * box.along;
        left = (along < -straight).count();
        right = (along > straight).count();
        corners = (corners_of(points) && along.abs() > straight).count();
    }
};

bool fits(const RoundedBox& box, double area, double slack)
{
    const double whole = 4.0 * box.half.prod() - (4.0 - pi) * box.radius * box.radius;
    return box.residual <= slack && std::abs(area - whole) <= most_missing_area * whole;
}

Outline outline_of(const RoundedBox& box, const Outline& circle, const Matrix3& frame)
{
    Outline outline = circle;
    outline.kind = is_slot(box) ? OutlineKind::slotted : OutlineKind::rectangular;
    outline.radius = is_slot(box) ? box.half.y() : box.radius;
    outline.length = 2.0 * box.half.x();
    outline.width = 2.0 * box.half.y();
    outline.residual = box.residual;
    outline.along = frame.leftCols<2>() * box.along;
    outline.center += frame.leftCols<2>() * box.center;
    return outline;
}

// The slot or rectangle fitted to the points. The tolerance of a slot follows from the faceting of
// its ends.
Outline boxed(const PlanePoints& points, const Outline& circle, const Matrix3& frame, Slack slack)
{
    const RoundedBox box = rounded_box(points);
    Outline found = outline_of(box, circle, frame);
    if (found.kind == OutlineKind::slotted)
    {
        const RoundEnds ends(points, box);
        if (std::min(ends.left, ends.right) < fewest_at_end)
            found.kind = OutlineKind::other;
        slack.form = std::min(slack.form, faceting_tolerance(ends.corners));
    }
    found.tolerance = slack.at(box.half.y());
    if (found.kind == OutlineKind::other || !fits(box, circle.area, found.tolerance))
    {
        found.kind = OutlineKind::other;
        found.radius = 0.0;
        found.residual = 0.0;
    }
    return found;
}

// Columns: two directions in the plane, and its normal.
Matrix3 frame_of(const Vector3& normal)
{
    Matrix3 frame;
    frame.col(2) = normal;
    frame.col(0) = normal.unitOrthogonal();
    frame.col(1) = normal.cross(frame.col(0));
    return frame;
}

}  // namespace

Outline fit_outline(const Points& loop, double roundness, double scatter)
{
    Outline circle;
    const Vector3 area = doubled_area(loop);
    circle.area = 0.5 * area.norm();
    circle.axis = area.normalized();
    const CircleFit fit = fit_circle(loop);
    // Chosen: a plane fitted to a rim leans by at most 25 degrees to its area.
    if (std::abs(fit.axis.dot(circle.axis)) > 0.9)
        circle.axis = fit.axis.dot(circle.axis) > 0.0 ? fit.axis : Vector3(-fit.axis);
    const Matrix3 frame = frame_of(circle.axis);
    circle.center = fit.centre;
    circle.radius = fit.radius;
    circle.along = frame.col(0);
    circle.length = circle.width = 2.0 * fit.radius;
    const Points off = loop.rowwise() - fit.centre.transpose();
    const PlanePoints flat = off * frame.leftCols<2>();
    circle.residual = (flat.rowwise().norm().array() - fit.radius).abs().maxCoeff();
    circle.bulge = (off * circle.axis).cwiseAbs().maxCoeff();

    const Slack most{roundness, scatter};
    const Eigen::Index corners = corners_of(flat).count();
    const Slack slack{std::min(roundness, faceting_tolerance(corners)), scatter};
    if (!fit.convergence.is_converged || loop.rows() < fewest_rim_points
        || !is_round(circle, rounded_box(flat), slack, corners))
        return boxed(flat, circle, frame, most);
    circle.kind = OutlineKind::round;
    circle.tolerance = slack.at(circle.radius);
    return circle;
}

}  // namespace sheetmorph::fitting

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/forms/rim_profile.h"

#include "sheetmorph/numerics/newton_minimum.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

namespace sheetmorph
{

namespace
{

constexpr Eigen::Index fewest_points = 6;

// Of the radius: how far a point may be from the outline, across and along the axis.
constexpr double across_tolerance = 0.02;
constexpr double along_tolerance = 0.05;

// Half the straight side of the shortest slot, over its radius.
constexpr double shortest_slot = 0.05;

// Enclosed area of the round ends over squared radius: 2.6 for a hexagon, 2 for three points an
// end.
constexpr double least_round_area = 1.8;

// Rounds of the fit, and the steps over the outline's size that count as small and as none.
constexpr int most_rounds = 100;
constexpr double settled = 1e-9;
constexpr double finest = 1e-16;

using Plane = Eigen::Matrix<double, Eigen::Dynamic, 2>;
using Vector2 = Eigen::Vector2d;

//! The outline in its plane.
struct Stadium
{
    Vector2 centre = Vector2::Zero();
    double angle = 0.0;  // of the segment
    double half_segment = 0.0;
    double radius = 1.0;

    Vector2 along() const { return {std::cos(angle), std::sin(angle)}; }
    Vector2 across() const { return {-std::sin(angle), std::cos(angle)}; }

    // From the nearest point of the segment.
    Vector2 arm(const Vector2& point) const
    {
        const Vector2 offset = point - centre;
        return offset - std::clamp(offset.dot(along()), -half_segment, half_segment) * along();
    }
};

Eigen::VectorXd misses(const Plane& points, const Stadium& shape)
{
    Eigen::VectorXd miss(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        miss(i) = shape.arm(points.row(i).transpose()).norm() - shape.radius;
    return miss;
}

// By centre (2), radius, and for slots half_segment and angle.
Eigen::MatrixXd jacobian(const Plane& points, const Stadium& shape, bool is_slot)
{
    Eigen::MatrixXd rows(points.rows(), is_slot ? 5 : 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
        const Vector2 point = points.row(i).transpose();
        const Vector2 out = shape.arm(point).normalized();
        rows.row(i).head<3>() << -out(0), -out(1), -1.0;
        if (!is_slot)
            continue;
        const double along = (point - shape.centre).dot(shape.along());
        const double end = std::clamp(along, -shape.half_segment, shape.half_segment);
        const bool is_beyond = std::abs(along) >= shape.half_segment;
        rows(i, 3) = is_beyond ? -std::copysign(1.0, along) * out.dot(shape.along()) : 0.0;
        rows(i, 4) = -end * out.dot(shape.across());
    }
    return rows;
}

Stadium stepped(const Stadium& shape, const Eigen::VectorXd& step)
{
    Stadium next = shape;
    next.centre += step.head<2>();
    next.radius += step(2);
    if (step.size() == 5)
    {
        next.half_segment = std::max(0.0, next.half_segment + step(3));
        next.angle += step(4);
    }
    return next;
}

//! An outline by Gauss-Newton steps for the distances to it; points in units of its size.
class OutlineProblem : public NewtonProblem
{
public:
    OutlineProblem(const Plane& points, const Stadium& start, bool is_slot)
        : points_(points), shape_(start), before_(start), is_slot_(is_slot)
    {
    }

    const Stadium& shape() const { return shape_; }

    double value() override { return misses(points_, shape_).squaredNorm(); }

    // Model 1 leaves alone what the points do not determine, as the angle of a slot that is round.
    std::optional<NewtonStep> step(int model) override
    {
        const Eigen::VectorXd miss = misses(points_, shape_);
        const Eigen::MatrixXd rows = jacobian(points_, shape_, is_slot_);
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor(rows);
        const bool is_determined = factor.rank() == rows.cols();
        if (model == 0 && !is_determined)
            return std::nullopt;
        NewtonStep found{-factor.solve(miss)};
        found.length = found.change.norm();
        found.slope = 2.0 * miss.dot(rows * found.change);
        found.is_exact = is_determined;
        return found;
    }

    void remember() override { before_ = shape_; }
    void restore() override { shape_ = before_; }
    void move(const NewtonStep& step, double share) override
    {
        shape_ = stepped(before_, share * step.change);
    }

private:
    const Plane& points_;
    Stadium shape_, before_;
    bool is_slot_;
};

// Nothing where the fit does not converge.
std::optional<Stadium> fitted(const Plane& points, const Stadium& start, bool is_slot)
{
    OutlineProblem problem(points, start, is_slot);
    NewtonLimits limits{"the outline"};
    limits.most_rounds = most_rounds;
    limits.settled = settled;
    limits.finest = finest;
    limits.models = 2;
    return newton_minimum(problem, limits).is_converged ? std::optional(problem.shape())
                                                        : std::nullopt;
}

Stadium first_circle(const Plane& points)
{
    Stadium circle;
    circle.centre = points.colwise().mean().transpose();
    circle.radius = (points.rowwise() - circle.centre.transpose()).rowwise().norm().mean();
    return circle;
}

// Along the pair of points farthest apart.
Stadium first_slot(const Plane& points)
{
    Vector2 longest = Vector2::Zero();
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            if ((points.row(i) - points.row(j)).norm() > longest.norm())
                longest = (points.row(i) - points.row(j)).transpose();
    Stadium slot;
    slot.angle = std::atan2(longest(1), longest(0));
    const Eigen::VectorXd along = points * slot.along();
    const Eigen::VectorXd across = points * slot.across();
    slot.centre = 0.5 * (along.maxCoeff() + along.minCoeff()) * slot.along()
                  + 0.5 * (across.maxCoeff() + across.minCoeff()) * slot.across();
    slot.radius = 0.5 * (across.maxCoeff() - across.minCoeff());
    slot.half_segment = std::max(0.0, 0.5 * (along.maxCoeff() - along.minCoeff()) - slot.radius);
    return slot;
}

// Three points at each end: a rectangle's corners alone are no slot.
bool has_round_ends(const Plane& points, const Stadium& slot)
{
    const Eigen::ArrayXd along = (points.rowwise() - slot.centre.transpose()) * slot.along();
    const double end = slot.half_segment - across_tolerance * slot.radius;
    return (along > end).count() >= 3 && (along < -end).count() >= 3;
}

// Whether the row of points goes around the outline: its area is enough to tell.
bool goes_around(const Plane& points, const Stadium& shape)
{
    double area = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
        const Eigen::Index next = (i + 1) % points.rows();
        area += 0.5 * (points(i, 0) * points(next, 1) - points(i, 1) * points(next, 0));
    }
    const double straight = 4.0 * shape.half_segment * shape.radius;
    return std::abs(area) > straight + least_round_area * shape.radius * shape.radius;
}

std::optional<Stadium> outline(const Plane& points)
{
    const auto fits = [&](const Stadium& shape)
    { return misses(points, shape).cwiseAbs().maxCoeff() < across_tolerance * shape.radius; };
    const std::optional<Stadium> circle = fitted(points, first_circle(points), false);
    if (circle && fits(*circle) && goes_around(points, *circle))
        return circle;
    const std::optional<Stadium> slot = fitted(points, first_slot(points), true);
    if (slot && slot->half_segment > shortest_slot * slot->radius && fits(*slot)
        && goes_around(points, *slot) && has_round_ends(points, *slot))
        return slot;
    return std::nullopt;
}

//! A plane with a unit of length, in which outlines are fitted.
struct Chart
{
    Vector3 origin;
    Matrix3 frame;
    double unit;

    Plane flat(const Points& points) const
    {
        return (points.rowwise() - origin.transpose()) * frame.leftCols<2>() / unit;
    }

    RimProfile profile(const Stadium& shape) const
    {
        RimProfile found;
        found.centre = origin + frame.leftCols<2>() * shape.centre * unit;
        found.frame.col(0) = frame.leftCols<2>() * shape.along();
        found.frame.col(1) = frame.leftCols<2>() * shape.across();
        found.frame.col(2) = frame.col(2);
        found.half_segment = shape.half_segment * unit;
        found.radius = shape.radius * unit;
        return found;
    }
};

Chart chart_of(const Points& rim)
{
    const Vector3 origin = (rim.row(0) + (rim.rowwise() - rim.row(0)).colwise().mean()).transpose();
    const Points offsets = rim.rowwise() - origin.transpose();
    Vector3 sense = Vector3::Zero();
    for (Eigen::Index i = 0; i < rim.rows(); ++i)
        sense += Vector3(offsets.row(i)).cross(Vector3(offsets.row((i + 1) % rim.rows())));
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(offsets, Eigen::ComputeThinV);
    Matrix3 frame = svd.matrixV();
    if (frame.col(2).dot(sense) < 0.0)
        frame.col(2) = -frame.col(2);
    frame.col(1) = frame.col(2).cross(frame.col(0));
    return {origin, frame, std::sqrt(offsets.squaredNorm() / static_cast<double>(rim.rows()))};
}

}  // namespace

double RimProfile::distance(const Vector3& point) const
{
    return (point - centre
            - std::clamp((point - centre).dot(frame.col(0)), -half_segment, half_segment)
                  * frame.col(0)
            - height(point) * frame.col(2))
               .norm()
           - radius;
}

Vector3 RimProfile::outward(const Vector3& point) const
{
    const Vector3 offset = point - centre;
    const Vector3 flat = offset - offset.dot(frame.col(2)) * frame.col(2);
    const Vector3 arm =
        flat - std::clamp(offset.dot(frame.col(0)), -half_segment, half_segment) * frame.col(0);
    return arm.norm() > 1e-9 * radius ? Vector3(arm.normalized()) : Vector3(Vector3::Zero());
}

double RimProfile::height(const Vector3& point) const
{
    return (point - centre).dot(frame.col(2));
}

double RimProfile::place_along(const Vector3& point) const
{
    return std::clamp((point - centre).dot(frame.col(0)) / half_segment, -1.0, 1.0);
}

std::optional<RimProfile> fit_rim(const Points& rim)
{
    if (rim.rows() < fewest_points)
        return std::nullopt;
    const Chart chart = chart_of(rim);
    if (!(chart.unit > 0.0))
        return std::nullopt;
    const std::optional<Stadium> found = outline(chart.flat(rim));
    if (!found)
        return std::nullopt;
    const RimProfile profile = chart.profile(*found);
    for (Eigen::Index i = 0; i < rim.rows(); ++i)
        if (std::abs(profile.height(rim.row(i).transpose())) > along_tolerance * profile.radius)
            return std::nullopt;
    return profile;
}

std::optional<RimProfile> refit(const RimProfile& profile, const Points& points)
{
    const double unit = profile.radius + profile.half_segment;
    const Chart chart{profile.centre, profile.frame, unit};
    const Stadium start{Vector2::Zero(), 0.0, profile.half_segment / unit, profile.radius / unit};
    const auto found = fitted(chart.flat(points), start, !profile.is_circle());
    return found ? std::optional(chart.profile(*found)) : std::nullopt;
}

}  // namespace sheetmorph

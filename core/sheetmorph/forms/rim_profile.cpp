// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/forms/rim_profile.h"

#include "sheetmorph/mesh/regions/outline.h"
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

// Of the radius: how far a point may be from the plane of the rim.
constexpr double along_tolerance = 0.05;

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

// A slot is fitted by least squares, so that noise counts less than in the outline's corners.
std::optional<RimProfile> slot_of(const Points& rim, const Outline& outline)
{
    Matrix3 frame;
    frame << outline.along, outline.axis.cross(outline.along), outline.axis;
    const double half = 0.5 * outline.width;
    const double segment = 0.5 * outline.length - half;
    const Chart chart{outline.center, frame, half + segment};
    const Plane points = chart.flat(rim);
    const Stadium start{Vector2::Zero(), 0.0, segment / chart.unit, half / chart.unit};
    const std::optional<Stadium> slot = fitted(points, start, true);
    if (!slot || misses(points, *slot).cwiseAbs().maxCoeff() * chart.unit > outline.tolerance
        || !(slot->half_segment > 0.0))
        return std::nullopt;
    return chart.profile(*slot);
}

// Whether the points enclose an area: no plane fits a slit or a single place.
bool goes_around_something(const Points& rim)
{
    constexpr double slimmest = 1e-8;
    const double area = doubled_area(rim).norm();
    return area > slimmest * (rim.rowwise() - rim.row(0)).squaredNorm();
}

RimProfile circle_of(const Outline& outline)
{
    RimProfile circle;
    circle.centre = outline.center;
    circle.frame << outline.along, outline.axis.cross(outline.along), outline.axis;
    circle.radius = outline.radius;
    return circle;
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

std::optional<RimProfile> fit_rim(const Points& rim, double scatter)
{
    if (rim.rows() < fewest_outline_vertices || !goes_around_something(rim))
        return std::nullopt;
    const Outline outline = fit_outline(rim, default_roundness, scatter);
    std::optional<RimProfile> profile;
    if (outline.kind == OutlineKind::round)
        profile = circle_of(outline);
    else if (outline.kind == OutlineKind::slotted)
        profile = slot_of(rim, outline);
    if (!profile)
        return std::nullopt;
    profile->tolerance = outline.tolerance;
    for (Eigen::Index i = 0; i < rim.rows(); ++i)
    {
        const Vector3 point = rim.row(i).transpose();
        if (std::abs(profile->height(point)) > along_tolerance * profile->radius)
            return std::nullopt;
        profile->residual = std::max(profile->residual, std::abs(profile->distance(point)));
    }
    return profile;
}

std::optional<RimProfile> refit(const RimProfile& profile, const Points& points)
{
    const double unit = profile.radius + profile.half_segment;
    const Chart chart{profile.centre, profile.frame, unit};
    const Stadium start{Vector2::Zero(), 0.0, profile.half_segment / unit, profile.radius / unit};
    const auto found = fitted(chart.flat(points), start, !profile.is_circle());
    if (!found)
        return std::nullopt;
    RimProfile better = chart.profile(*found);
    better.tolerance = profile.tolerance;
    better.residual = profile.residual;
    return better;
}

}  // namespace sheetmorph

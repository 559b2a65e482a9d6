// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/rim_profile.h"

#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/fitting/outline.h"
#include "sheetmorph/fitting/stadium.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace sheetmorph::fitting
{

namespace
{

// Largest distance of a point from the plane of the rim, relative to the radius. Chosen: a rim on a
// sheet curved with ten times its radius deviates by a fortieth (r^2 / 4 R), half of this.
constexpr double along_tolerance = 0.05;

// Returns nothing if the fit does not converge.
std::optional<Stadium> fitted(const PlanePoints& points, Stadium shape, bool is_slot)
{
    const StadiumFit how{"the outline", is_slot, true};
    return fit_stadium(points, how, shape).is_converged ? std::optional(shape) : std::nullopt;
}

//! A plane and a unit of length for fitting outlines in two dimensions.
struct Chart
{
    Vector3 origin;
    Matrix3 frame;
    double unit;

    PlanePoints flat(const Points& points) const
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

// Least squares reduce the noise of the corners of the outline.
std::optional<RimProfile> slot_of(const Points& rim, const Outline& outline)
{
    Matrix3 frame;
    frame << outline.along, outline.axis.cross(outline.along), outline.axis;
    const double half = 0.5 * outline.width;
    const double segment = 0.5 * outline.length - half;
    const Chart chart{outline.center, frame, half + segment};
    const PlanePoints points = chart.flat(rim);
    const Stadium start{Eigen::Vector2d::Zero(), 0.0, segment / chart.unit, half / chart.unit};
    const std::optional<Stadium> slot = fitted(points, start, true);
    if (!slot || slot->misses(points).cwiseAbs().maxCoeff() * chart.unit > outline.tolerance
        || !(slot->half_segment > 0.0))
        return std::nullopt;
    return chart.profile(*slot);
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
    // On the axis there is no direction; from the accuracy of 1e-9.
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
    if (rim.rows() < fewest_rim_points || !encloses_area(rim))
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
    const Stadium start{Eigen::Vector2d::Zero(), 0.0, profile.half_segment / unit,
                        profile.radius / unit};
    const auto found = fitted(chart.flat(points), start, !profile.is_circle());
    if (!found)
        return std::nullopt;
    RimProfile better = chart.profile(*found);
    better.tolerance = profile.tolerance;
    better.residual = profile.residual;
    return better;
}

}  // namespace sheetmorph::fitting

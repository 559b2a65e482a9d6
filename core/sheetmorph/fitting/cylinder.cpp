// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/cylinder.h"

#include <Eigen/Geometry>

namespace sheetmorph::fitting
{

namespace
{

// Largest deviation, relative to the radius.
constexpr double tolerance = 0.02;

// Below 30 degrees of arc the normals do not determine the axis. Measurement noise also spreads the
// normals along the axis.
constexpr SpreadLimits spread{0.01, 0.02};

}  // namespace

std::optional<RimProfile> fit_cylinder(const FacetSample& facets)
{
    if (facets.areas.size() < 2 || facets.corners.rows() < 6)
        return std::nullopt;
    const auto start = fit_surface(facets, Surface::Kind::cylinder, spread);
    if (!start)
        return std::nullopt;
    const Surface surface = refined(facets.corners, *start);
    if (!(surface.radius > 0.0 && misfit_of(facets.corners, surface) <= tolerance))
        return std::nullopt;
    const Vector3 middle = facets.corners.colwise().mean().transpose();
    RimProfile cylinder;
    cylinder.frame.col(2) = surface.axis;
    cylinder.frame.col(0) = surface.axis.unitOrthogonal();
    cylinder.frame.col(1) = surface.axis.cross(cylinder.frame.col(0));
    cylinder.centre = surface.point + (middle - surface.point).dot(surface.axis) * surface.axis;
    cylinder.radius = surface.radius;
    return cylinder;
}

}  // namespace sheetmorph::fitting

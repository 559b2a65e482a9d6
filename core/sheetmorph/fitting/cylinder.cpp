// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/cylinder.h"

#include <Eigen/Geometry>

namespace sheetmorph::fitting
{

namespace
{

// Largest deviation, relative to the radius. From geometry: a vertex on a chord deviates by
// 1 - cos(pi / 16) = 0.019 if 16 facets go around.
constexpr double tolerance = 0.02;

// From geometry: normals of an arc a have a mean square of (1 - sin(a) / a) / 2 across its middle,
// 0.02 at 28 degrees. On a smaller arc they do not determine the axis. Along the axis, noise may
// spread them by 6 degrees (0.1 radians, squared).
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

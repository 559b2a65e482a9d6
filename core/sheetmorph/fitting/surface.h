// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <cmath>
#include <optional>

namespace sheetmorph::fitting
{

//! A plane, cylinder, cone or sphere in space.
struct Surface
{
    enum class Kind
    {
        plane,
        cylinder,
        cone,
        sphere
    };

    Kind kind = Kind::plane;
    Vector3 point = Vector3::Zero();  //!< on the plane or axis, apex or centre, mm
    //! Normal or axis, length 1; that of a cone points away from the apex.
    Vector3 axis = Vector3::UnitZ();
    double radius = 0.0;  //!< of cylinder and sphere, mm
    double angle = 0.0;   //!< of a cone, between axis and surface, radians

    //! Distance of a point from the surface, mm. offset() is signed along the normal.
    double distance(const Vector3& place) const { return std::abs(offset(place)); }
    double offset(const Vector3& place) const;

    //! The normal at a point, length 1; its sign is not defined.
    Vector3 normal(const Vector3& place) const;

    //! The radius at a point, mm, to which residuals are relative.
    double radius_at(const Vector3& place) const;
};

//! Geometry of the facets that a surface is fitted to.
struct FacetSample
{
    Points corners;         //!< (k, 3) mm; repetitions are allowed
    Points normals;         //!< (m, 3) of length 1; 0 for a degenerate facet
    Points centroids;       //!< (m, 3) mm
    Eigen::VectorXd areas;  //!< (m) mm^2
};

//! Limits for the spread of normals, which distinguishes the kinds of surfaces. They apply to the
//! eigenvalues of the second moments of the normals, weighted by area and divided by the total
//! area.
struct SpreadLimits
{
    //! Below it, normals lie in a plane through the origin. Chosen: 3.6 degrees from it, squared;
    //! a cylinder with scatter stays below, a cone with a half angle of 6 degrees exceeds it.
    double flattest = 0.004;
    //! Above it, the surface is curved. From geometry: an arc a has a^2 / 12, so 9 degrees. The
    //! bend inside a plane (FeatureTolerances::plane_angle, 6 degrees) stays below.
    double turning = 0.002;
};

//! Fits a surface of one kind to facets, from their normals and corners. Returns nothing if the
//! normals do not belong to that kind.
std::optional<Surface> fit_surface(const FacetSample& facets, Surface::Kind kind,
                                   const SpreadLimits& limits = {});

//! Fits a surface to points by least squares of their distances (Levenberg-Marquardt). Returns the
//! initial guess if no step reduces the sum.
//! \param points  (k, 3) mm
Surface refined(const Points& points, const Surface& start);

//! The largest distance of a point from the surface, relative to the radius there.
//! \param points  (k, 3) mm
double misfit_of(const Points& points, const Surface& surface);

}  // namespace sheetmorph::fitting

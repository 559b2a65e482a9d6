// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <cmath>
#include <optional>

namespace sheetmorph
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
    Vector3 point = Vector3::Zero();  //!< on the plane or axis, apex, center, mm
    Vector3 axis = Vector3::UnitZ();  //!< normal or axis, length 1; of a cone away
                                      //!< from its apex
    double radius = 0.0;              //!< of cylinder and sphere, mm
    double angle = 0.0;               //!< of a cone, between axis and surface, radians

    //! Distance of a point from it, mm; offset: to which side, along the normal.
    double distance(const Vector3& place) const { return std::abs(offset(place)); }
    double offset(const Vector3& place) const;

    //! Its normal at a place, length 1, to either side.
    Vector3 normal(const Vector3& place) const;

    //! What residuals are compared with: the radius at a place, mm.
    double radius_at(const Vector3& place) const;
};

//! Facets that a surface is fitted to.
struct FacetSample
{
    Points corners;         //!< (k, 3) mm, each at least once
    Points normals;         //!< (m, 3) of length 1; 0 where a facet has no plane
    Points centroids;       //!< (m, 3) mm
    Eigen::VectorXd areas;  //!< (m) mm^2
};

//! Shares of the spread of normals that tell surfaces apart.
struct SpreadLimits
{
    double flattest = 0.004;  //!< below it, normals lie in a plane through the origin
    double turning = 0.002;   //!< above it, normals turn at all
};

//! A surface of one kind through facets, from their normals and corners; nothing where their
//! normals are not those of that kind.
std::optional<Surface> fit_surface(const FacetSample& facets, Surface::Kind kind,
                                   const SpreadLimits& limits = {});

//! The surface with the least squared distances from points (Levenberg and Marquardt): exact where
//! they were drawn on one. A start that nothing betters is returned.
//! \param points  (k, 3) mm
Surface refined(const Points& points, const Surface& start);

//! The largest distance of a point over the radius there. \param points  (k, 3) mm
double misfit_of(const Points& points, const Surface& surface);

}  // namespace sheetmorph

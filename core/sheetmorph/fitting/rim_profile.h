// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <optional>

namespace sheetmorph::fitting
{

//! The outline of a hole or slot, extruded along its axis: all points at a fixed distance from a
//! segment. A segment of length 0 gives a circle.
struct RimProfile
{
    Vector3 centre = Vector3::Zero();     //!< mm
    Matrix3 frame = Matrix3::Identity();  //!< columns: along the segment, across, axis
    double half_segment = 0.0;            //!< mm; 0 for a circle
    double radius = 0.0;                  //!< mm
    double tolerance = 0.0;  //!< the largest deviation allowed for points of the rim, mm
    double residual = 0.0;   //!< the largest deviation of the fitted points, mm

    bool is_circle() const { return half_segment == 0.0; }

    //! Distance from the outline at right angles to the axis, mm; negative inside.
    double distance(const Vector3& point) const;

    //! Gradient direction of distance(), at right angles to the axis, length 1; zero on the
    //! segment.
    Vector3 outward(const Vector3& point) const;

    //! Coordinate along the axis from the centre, mm.
    double height(const Vector3& point) const;

    //! Coordinate along the segment of a slot: -1 and 1 at its ends and beyond.
    double place_along(const Vector3& point) const;
};

//! The circle or slot through a closed rim. Returns nothing if fit_outline() finds neither, or if a
//! point is farther from the plane than 5 % of the radius.
//! \param rim      (k, 3) mm, in order
//! \param scatter  of the mesh, as for fit_outline()
std::optional<RimProfile> fit_rim(const Points& rim, double scatter = 0.0);

//! Fits an outline to points near it by least squares, with the axis unchanged. Returns nothing if
//! the fit does not converge.
//! \param points  (k, 3) mm, in any order
std::optional<RimProfile> refit(const RimProfile& profile, const Points& points);

}  // namespace sheetmorph::fitting

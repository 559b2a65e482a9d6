// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <optional>

namespace sheetmorph
{

//! The outline of a hole or slot, drawn out along its axis: all points at one distance from a
//! segment (a circle, where the segment has no length).
struct RimProfile
{
    Vector3 centre = Vector3::Zero();     //!< mm
    Matrix3 frame = Matrix3::Identity();  //!< columns: along the segment, across, axis
    double half_segment = 0.0;            //!< mm; 0 for a circle
    double radius = 0.0;                  //!< mm
    double tolerance = 0.0;               //!< how far points of the rim may be from it, mm
    double residual = 0.0;                //!< how far its own points are from it at most, mm

    bool is_circle() const { return half_segment == 0.0; }

    //! Distance from the outline at right angles to the axis, mm; negative inside.
    double distance(const Vector3& point) const;

    //! The direction in which distance() grows fastest; of length 1, at right angles to the axis.
    Vector3 outward(const Vector3& point) const;

    //! How far along the axis from the centre, mm.
    double height(const Vector3& point) const;

    //! Place along the segment: -1 and 1 at its ends and beyond, for slots.
    double place_along(const Vector3& point) const;
};

//! The circle or slot that a closed row of points runs around, as fit_outline() decides it; nothing
//! if it is neither, or if a point is farther from its plane than 5 % of the radius.
//! \param rim      (k, 3) mm, in order
//! \param scatter  of the mesh, as for fit_outline()
std::optional<RimProfile> fit_rim(const Points& rim, double scatter = 0.0);

//! The outline through points near one: the same axis, its other numbers by least squares; nothing
//! if they do not settle.
//! \param points  (k, 3) mm, in any order
std::optional<RimProfile> refit(const RimProfile& profile, const Points& points);

}  // namespace sheetmorph

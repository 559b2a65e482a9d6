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

//! The outline that a closed row of points runs around, if it is one: within 2 % of its radius
//! across the axis and 5 % along it, at least 6 points, 3 at each end of a slot.
//! \param rim  (k, 3) mm, in order
std::optional<RimProfile> fit_rim(const Points& rim);

//! The outline through points near one: the same axis, its other numbers by least squares; nothing
//! if they do not settle.
//! \param points  (k, 3) mm, in any order
std::optional<RimProfile> refit(const RimProfile& profile, const Points& points);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <optional>

namespace sheetmorph::cad
{

//! What became of a face or edge that keeps its surface or curve: a rigid motion, and before it, of
//! a cylinder, another radius.
struct KeptMotion
{
    gp_Trsf motion;
    gp_Ax1 axis;
    double scale = 1.0;  //!< of distances from the axis

    Vector3 point(const Vector3& before) const;
    Handle(Geom_Surface) surface(const Handle(Geom_Surface) & before) const;

    //! \returns null for a curve that becomes another one: neither a circle about the axis nor a
    //!          line along it
    Handle(Geom_Curve) curve(const Handle(Geom_Curve) & before) const;
};

//! The rigid motion that takes rows of `from` to rows of `to`, none if one is off by more than
//! `tolerance` (mm).
//! \param is_straight  whether a straight row is enough, else points must span a plane
std::optional<KeptMotion> rigid_fit(const Points& from, const Points& to, double tolerance,
                                    bool is_straight);

//! The same with another distance from the axis of a cylinder; none for another surface.
std::optional<KeptMotion> resized_fit(const Points& from, const Points& to, double tolerance,
                                      const Handle(Geom_Surface) & surface);

}  // namespace sheetmorph::cad

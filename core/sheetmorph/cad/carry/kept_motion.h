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

//! The motion of a face or edge that keeps its surface or curve: a change of radius, for a
//! cylinder, then a rigid motion.
struct KeptMotion
{
    gp_Trsf motion;
    gp_Ax1 axis;
    double scale = 1.0;  //!< of distances from the axis

    Vector3 point(const Vector3& before) const;
    Handle(Geom_Surface) surface(const Handle(Geom_Surface) & before) const;

    //! \returns null if the curve becomes another one: neither a circle about the axis nor a line
    //!     along it
    Handle(Geom_Curve) curve(const Handle(Geom_Curve) & before) const;
};

//! The rigid motion that takes the rows of `from` to the rows of `to`; nothing if a row deviates by
//! more than `tolerance` (mm).
//! \param is_straight  whether collinear points suffice; otherwise they must span a plane
std::optional<KeptMotion> rigid_fit(const Points& from, const Points& to, double tolerance,
                                    bool is_straight);

//! The same with a change of a cylinder's radius; nothing for other surfaces.
std::optional<KeptMotion> resized_fit(const Points& from, const Points& to, double tolerance,
                                      const Handle(Geom_Surface) & surface);

}  // namespace sheetmorph::cad

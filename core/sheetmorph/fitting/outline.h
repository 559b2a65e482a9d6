// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::fitting
{

enum class OutlineKind
{
    round,
    slotted,
    rectangular,  //!< with sharp or rounded corners
    other
};

//! What a closed line is: a circle, a slot, a rectangle with rounded corners,
//! or none of them.
struct Outline
{
    OutlineKind kind = OutlineKind::other;
    Vector3 center = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();   //!< normal of its plane, length 1, as it runs
    Vector3 along = Vector3::UnitX();  //!< of its longer side, length 1
    double radius = 0.0;               //!< of the circle, half the slot's width, of the corners, mm
    double length = 0.0;               //!< mm, diameter of a circle
    double width = 0.0;                //!< mm
    double residual = 0.0;             //!< largest distance of a point from it, in its plane, mm
    double bulge = 0.0;                //!< largest distance of a point from the plane, mm
    double area = 0.0;                 //!< enclosed by the polygon, mm^2
    double tolerance = 0.0;            //!< how far a point may be from a circle or slot, mm
};

//! The default of `roundness` below, no unit.
constexpr double default_roundness = 0.12;

//! The simplest outline that fits closed points: a circle or slot to its own faceting, a rectangle
//! to `roundness` of its half width. The one place that decides what a rim is.
//!
//! Faceting is the sagitta of a regular polygon with as many corners, 1 - cos(pi / corners) of the
//! radius, because a mesher may put vertices anywhere between arc and chord; 3 % at least, which
//! formed holes need. Vertices within straight sides are no corners.
//! \param loop       (k, 3) mm, k >= 3, in order around, not on one line
//! \param roundness  no unit: the most that any tolerance may be
//! \param scatter    standard deviation of the points in one direction, mm: a fit may be off by
//!                   thrice that besides
Outline fit_outline(const Points& loop, double roundness = default_roundness, double scatter = 0.0);

}  // namespace sheetmorph::fitting

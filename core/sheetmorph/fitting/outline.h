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

//! The outline fitted to a closed loop: a circle, a slot, a rectangle with rounded corners, or none
//! of these.
struct Outline
{
    OutlineKind kind = OutlineKind::other;
    Vector3 center = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();   //!< plane normal, length 1, by the direction of the loop
    Vector3 along = Vector3::UnitX();  //!< direction of the longer side, length 1
    double radius = 0.0;     //!< of the circle, of the corners, or half the slot's width, mm
    double length = 0.0;     //!< mm; diameter of a circle
    double width = 0.0;      //!< mm; diameter of a circle
    double residual = 0.0;   //!< largest distance of a point from the outline in its plane, mm
    double bulge = 0.0;      //!< largest distance of a point from the plane, mm
    double area = 0.0;       //!< of the polygon, mm^2
    double tolerance = 0.0;  //!< largest distance allowed between a point and the outline, mm
};

//! Default of `roundness` in fit_outline(), no unit. From geometry: the sagitta of a hexagon is
//! 0.134 of the radius, so a vertex at the middle of a side of a hexagon is out and one of a
//! heptagon (0.099) is in.
constexpr double default_roundness = 0.12;

//! Fits the simplest outline to a closed loop: a circle or slot within the tolerance of its
//! faceting, else a rectangle within `roundness` of its half width. All code that classifies rims
//! uses this function.
//! The faceting tolerance is the sagitta of a regular polygon with the same number of corners,
//!   radius (1 - cos(pi / corners)) ,
//! and at least 3 % of the radius, for the sake of formed holes. A mesher may put vertices anywhere
//! between arc and chord. Vertices inside straight sides do not count as corners.
//! \param loop       (k, 3) mm, k >= 3, in order, not collinear
//! \param roundness  upper limit of all relative tolerances, no unit
//! \param scatter    standard deviation of the points in one direction, mm; three times this value
//!                   widens the tolerance
Outline fit_outline(const Points& loop, double roundness = default_roundness, double scatter = 0.0);

}  // namespace sheetmorph::fitting

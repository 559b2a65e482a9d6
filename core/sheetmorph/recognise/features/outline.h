// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/features/feature.h"

namespace sheetmorph
{

//! What a closed line is: a circle, a slot, a rectangle with rounded corners,
//! or none of them.
struct Outline
{
    FeatureKind kind = FeatureKind::hole;  //!< one of the four kinds of holes
    Vector3 center = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();   //!< normal of its plane, length 1, as it runs
    Vector3 along = Vector3::UnitX();  //!< of its longer side, length 1
    double radius = 0.0;               //!< of the circle, half the slot's width, of the corners, mm
    double length = 0.0;               //!< mm, diameter of a circle
    double width = 0.0;                //!< mm
    double residual = 0.0;             //!< largest distance of a point from it, in its plane, mm
    double bulge = 0.0;                //!< largest distance of a point from the plane, mm
    double area = 0.0;                 //!< enclosed by the polygon, mm^2
};

//! What a raised place of this length and width is called: a bead or an emboss.
FeatureKind raised_kind(double length, double width);

//! The simplest outline that fits closed points to `roundness` of its (half)
//! width. \param loop  (k, 3) mm, k >= 3, in order around, not on one line
//! \param scatter  standard deviation of the points in one direction, mm: a fit may be off by
//!                 thrice that besides
Outline fit_outline(const Points& loop, double roundness, double scatter = 0.0);

//! Twice the area vector of a closed polygon: its normal times twice its area,
//! mm^2.
Vector3 doubled_area(const Points& loop);

}  // namespace sheetmorph

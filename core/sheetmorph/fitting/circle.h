// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/types.h"

#include <optional>

namespace sheetmorph::fitting
{

//! A circle in space fitted to points, mm.
struct CircleFit
{
    Vector3 centre = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();  //!< length 1; the points run counter-clockwise around it
    double radius = 0.0;
    double residual = 0.0;         //!< largest distance of a point from the circle
    Convergence convergence = {};  //!< not converged if the points are nearly collinear
};

//! Fewest points of a rim that can be a circle or a slot. From the unknowns of a slot: its centre
//! (2), angle, length and width are five.
constexpr int fewest_rim_points = 6;

//! Area vector of a closed polygon: its normal times twice its area, mm^2.
//! \param loop  (k, 3) mm, in order
Vector3 doubled_area(const Points& loop);

//! Whether a closed polygon encloses an area, unlike a slit or a point.
bool encloses_area(const Points& loop);

//! Fits a circle to points by least squares in their best-fitting plane. The result is exact to
//! rounding for points on a circle, also far from the origin. If the points have no sense of
//! rotation, the largest component of the axis is positive.
//! \param points  (k, 3) mm, k >= 3, in any order
//! \throws InvalidInput for fewer points, collinear points, or coordinates that are not finite
CircleFit fit_circle(const Points& points);

//! The circle through a closed rim. Returns nothing if a vertex deviates by more than tolerance *
//! radius, if the rim encloses no area, or if the fit does not converge.
//! \param rim        (k, 3) mm, in order
//! \param tolerance  no unit, > 0
std::optional<CircleFit> round_rim(const Points& rim, double tolerance);

}  // namespace sheetmorph::fitting

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/types.h"

#include <optional>

namespace sheetmorph::fitting
{

//! A circle in space through points, mm.
struct CircleFit
{
    Vector3 centre = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();  //!< of length 1; the points run around it counter-clockwise
    double radius = 0.0;
    double residual = 0.0;         //!< largest distance of a point from the circle
    Convergence convergence = {};  //!< the fit of nearly collinear points does not converge
};

//! Fewest points of a rim that may be a circle or a slot.
constexpr int fewest_rim_points = 6;

//! Twice the area vector of a closed polygon: its normal times twice its area, mm^2.
//! \param loop  (k, 3) mm, in order
Vector3 doubled_area(const Points& loop);

//! Whether a closed polygon encloses an area; a slit or a point does not.
bool encloses_area(const Points& loop);

//! The circle in the points' best plane with the least sum of squared distances in that plane.
//! Exact circles are found to rounding, far from the origin too. Points without a sense of rotation
//! take the axis whose largest component is positive.
//! \param points  (k, 3) mm, k >= 3, in any order
//! \throws InvalidInput for fewer points, points on one line, or coordinates that are not finite
CircleFit fit_circle(const Points& points);

//! The circle through a closed rim, or nothing if a vertex deviates by more than
//! tolerance * radius, the rim encloses no area, or the fit does not converge.
//! \param rim        (k, 3) mm, in order
//! \param tolerance  no unit, > 0
std::optional<CircleFit> round_rim(const Points& rim, double tolerance);

}  // namespace sheetmorph::fitting

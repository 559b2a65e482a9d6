// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/triangle_mesh.h"

#include <optional>

namespace sheetmorph
{

//! A circle in space through points, mm.
struct CircleFit
{
    Vector3 centre = Vector3::Zero();
    Vector3 axis = Vector3::UnitZ();  //!< of length 1; the points run around it counter-clockwise
    double radius = 0.0;
    double residual = 0.0;         //!< largest distance of a point from the circle
    Convergence convergence = {};  //!< of the fit: nearly straight rows of points settle nowhere
};

//! The circle in the points' best plane with the least sum of squared distances in that plane.
//! Exact circles are found to rounding, far from the origin too. Points without a sense of rotation
//! take the axis whose largest component is positive.
//! \param points  (k, 3) mm, k >= 3, in any order
//! \throws InvalidInput for fewer points, points on one line, or coordinates that are not finite
CircleFit fit_circle(const Points& points);

//! The circle a closed rim of at least 6 points is, within tolerance * radius; nothing if it is
//! none, has no extent, or no circle settles on it.
//! \param rim        (k, 3) mm, in order
//! \param tolerance  no unit, > 0
std::optional<CircleFit> round_rim(const Points& rim, double tolerance);

//! A boundary loop that is a circle.
struct RoundHole
{
    VertexIds rim;  //!< in order, as boundary_loops gives it
    CircleFit circle;
};

//! The boundary loops of at least 6 vertices whose residual is below tolerance * radius, in the
//! order of boundary_loops; a round outer border is one of them.
//! \param tolerance  no unit, > 0
std::vector<RoundHole> round_holes(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph

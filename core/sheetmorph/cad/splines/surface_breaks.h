// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/splines/face_spline.h"

#include <Geom_Curve.hxx>

namespace sheetmorph::cad
{

//! Places inside a patch where a surface has no second derivative in u (direction 0) or v (1).
std::vector<CubicBasis::Break> surface_breaks(const SurfacePatch& patch, int direction);

//! The same along a curve, between two parameters.
std::vector<CubicBasis::Break> curve_breaks(const Handle(Geom_Curve) & curve, double low,
                                            double high);

}  // namespace sheetmorph::cad

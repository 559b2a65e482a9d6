// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>

namespace sheetmorph
{

//! A curve in the parameters of a face between two of its own, as a spline with the same ones: a
//! STEP file does not say where an edge ends on a line, and makes circles splines of others.
//! Readers then look for the edge on the face, which takes long on large splines.
Handle(Geom2d_Curve)
    spline_in_parameters(const Handle(Geom2d_Curve) & curve, double low, double high);

}  // namespace sheetmorph

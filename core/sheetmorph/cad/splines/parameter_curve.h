// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/splines/cubic_basis.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace sheetmorph::cad
{

//! A curve in the parameters of a face between two of its own parameters, as a spline with the same
//! ones. A STEP file does not store where an edge ends on a line, and stores other circles as
//! splines. Readers then search for the edge on the face, which takes long on large splines.
Handle(Geom2d_Curve)
    spline_in_parameters(const Handle(Geom2d_Curve) & curve, double low, double high);

//! The curve in the parameters of a surface that lies beneath a curve in space, at the same
//! parameters. Returns the curve of the file unless it deviates along the surface by more than a
//! tolerance, mm. A surface that follows both curves would fold between them.
Handle(Geom2d_Curve)
    curve_beneath(const Handle(Geom_Curve) & curve, const Handle(Geom_Surface) & surface,
                  const Handle(Geom2d_Curve) & of_file, double low, double high, double tolerance);

//! The border of a surface along which a curve in its parameters runs evenly from one end of a
//! range to the other, as a curve in space with that range; null if there is none.
Handle(Geom_BSplineCurve)
    border_above(const Handle(Geom2d_Curve) & curve, const Handle(Geom_BSplineSurface) & surface,
                 double low, double high);

//! A cubic spline in two parameters.
//! \param poles  (count, 2)
Handle(Geom2d_BSplineCurve) flat_spline(const CubicBasis& basis, const Eigen::MatrixXd& poles);

}  // namespace sheetmorph::cad

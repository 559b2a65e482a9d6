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

//! A curve in the parameters of a face between two of its own, as a spline with the same ones: a
//! STEP file does not say where an edge ends on a line, and makes circles splines of others.
//! Readers then look for the edge on the face, which takes long on large splines.
Handle(Geom2d_Curve)
    spline_in_parameters(const Handle(Geom2d_Curve) & curve, double low, double high);

//! The curve in the parameters of a surface that lies beneath a curve in space, at the same
//! parameters of its own: the one of the file, unless that is farther along the surface from the
//! points beneath than a tolerance, mm. A surface that follows both would be folded between them.
Handle(Geom2d_Curve)
    curve_beneath(const Handle(Geom_Curve) & curve, const Handle(Geom_Surface) & surface,
                  const Handle(Geom2d_Curve) & of_file, double low, double high, double tolerance);

//! The border of a surface along which a curve in its parameters runs evenly from one end of a
//! range to the other, as a curve in space with that range; nothing if it does not run so.
Handle(Geom_BSplineCurve)
    border_above(const Handle(Geom2d_Curve) & curve, const Handle(Geom_BSplineSurface) & surface,
                 double low, double high);

//! A spline of third degree in two parameters.
//! \param poles  (count, 2)
Handle(Geom2d_BSplineCurve) flat_spline(const CubicBasis& basis, const Eigen::MatrixXd& poles);

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/splines/cubic_basis.h"

#include <Geom_BSplineCurve.hxx>
#include <functional>

namespace sheetmorph::cad
{

//! A point for every parameter, mm.
using PointAt = std::function<Vector3(double parameter)>;

//! A cubic spline in space.
struct SplineCurve
{
    CubicBasis basis;
    Eigen::MatrixXd poles;  //!< (count, 3) mm

    Vector3 at(double t) const;
    Vector3 derivative(double t) const;
    Handle(Geom_BSplineCurve) curve() const;
};

//! The spline through points at ascending parameters, with continuous third derivatives at the
//! second and the last but one (not-a-knot). A parabola through three points, a line through two.
//! \param is_closed  whether it continues smoothly from its last point to the first
SplineCurve curve_through(const std::vector<double>& parameters, const Points& points,
                          bool is_closed);

//! A spline with the breaks of `start`, and further ones as needed, within `tolerance` (mm) of a
//! curve. It has the ends of the curve.
SplineCurve curve_near(const PointAt& curve, const CubicBasis& start, double tolerance);

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/parameter_curve.h"
#include "sheetmorph/cad/splines/spline_curve.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

namespace sheetmorph
{

Handle(Geom2d_Curve)
    spline_in_parameters(const Handle(Geom2d_Curve) & curve, double low, double high)
{
    if (!Handle(Geom2d_BSplineCurve)::DownCast(curve).IsNull())
        return curve;
    constexpr double exact = 1e-6;
    const auto place = [&](double t) -> Vector3 {
        return {curve->Value(t).X(), curve->Value(t).Y(), 0.0};
    };
    const bool is_line =
        Geom2dAdaptor_Curve(curve).GetType() == GeomAbs_Line;  // a trimmed one, too
    const Handle(Geom_BSplineCurve) spline =
        is_line ? Handle(Geom_BSplineCurve)()
                : curve_near(place, CubicBasis(low, high), exact).curve();
    const int poles = is_line ? 2 : spline->NbPoles(), knots = is_line ? 2 : spline->NbKnots();
    TColgp_Array1OfPnt2d points(1, poles);
    TColStd_Array1OfReal at(1, knots);
    TColStd_Array1OfInteger times(1, knots);
    for (int k = 1; k <= poles; ++k)
        points.SetValue(k, is_line ? curve->Value(k == 1 ? low : high)
                                   : gp_Pnt2d(spline->Pole(k).X(), spline->Pole(k).Y()));
    for (int k = 1; k <= knots; ++k)
    {
        at.SetValue(k, is_line ? (k == 1 ? low : high) : spline->Knot(k));
        times.SetValue(k, is_line ? 2 : spline->Multiplicity(k));
    }
    return new Geom2d_BSplineCurve(points, at, times, is_line ? 1 : 3);
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/parameter_curve.h"
#include "sheetmorph/cad/splines/spline_curve.h"
#include "sheetmorph/cad/splines/surface_breaks.h"

#include <BSplCLib.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Vec.hxx>

namespace sheetmorph::cad
{

namespace
{

Handle(Geom2d_Curve) line(const gp_Pnt2d& from, const gp_Pnt2d& to, double low, double high)
{
    TColgp_Array1OfPnt2d points(1, 2);
    TColStd_Array1OfReal at(1, 2);
    TColStd_Array1OfInteger times(1, 2);
    points.SetValue(1, from);
    points.SetValue(2, to);
    at.SetValue(1, low);
    at.SetValue(2, high);
    times.Init(2);
    return new Geom2d_BSplineCurve(points, at, times, 1);
}

// A surface with the range of its parameters.
class Ground
{
public:
    explicit Ground(const Handle(Geom_Surface) & surface) : surface_(surface)
    {
        surface->Bounds(low_(0), high_(0), low_(1), high_(1));
        if (surface->IsUPeriodic())
            open(0);
        if (surface->IsVPeriodic())
            open(1);
    }

    //! The step from parameters to those beneath a point, to first order; zero at a pole.
    Vector2 step(const Vector2& uv, const gp_Pnt& point) const
    {
        gp_Pnt here;
        gp_Vec u, v;
        surface_->D1(uv(0), uv(1), here, u, v);
        const gp_Vec way(here, point);
        const double uu = u.Dot(u), vv = v.Dot(v), mixed = u.Dot(v);
        const double squared = uu * vv - mixed * mixed;
        if (!(squared > 1e-6 * uu * vv))
            return Vector2::Zero();
        const Vector2 found(vv * u.Dot(way) - mixed * v.Dot(way),
                            uu * v.Dot(way) - mixed * u.Dot(way));
        return (uv + found / squared).cwiseMax(low_).cwiseMin(high_) - uv;
    }

    //! Length per unit of each parameter, mm.
    Vector2 scale(const Vector2& uv) const
    {
        gp_Pnt here;
        gp_Vec u, v;
        surface_->D1(uv(0), uv(1), here, u, v);
        return Vector2(u.Magnitude(), v.Magnitude()).cwiseMax(1e-12);
    }

private:
    void open(int direction)
    {
        low_(direction) = -1e300;
        high_(direction) = 1e300;
    }

    Handle(Geom_Surface) surface_;
    Vector2 low_, high_;
};

Vector2 place_at(const Handle(Geom2d_Curve) & curve, double t)
{
    const gp_Pnt2d uv = curve->Value(t);
    return {uv.X(), uv.Y()};
}

}  // namespace

Handle(Geom2d_Curve)
    spline_in_parameters(const Handle(Geom2d_Curve) & curve, double low, double high)
{
    if (!Handle(Geom2d_BSplineCurve)::DownCast(curve).IsNull())
        return curve;
    if (Geom2dAdaptor_Curve(curve).GetType() == GeomAbs_Line)  // also if trimmed
        return line(curve->Value(low), curve->Value(high), low, high);
    constexpr double exact = 1e-6;  // in parameters; chosen: below CarryTolerances::edge, 5e-4 mm
    const auto place = [&](double t) -> Vector3
    { return (Vector3() << place_at(curve, t), 0.0).finished(); };
    const SplineCurve found = curve_near(place, CubicBasis(low, high), exact);
    return flat_spline(found.basis, found.poles.leftCols<2>());
}

Handle(Geom2d_Curve)
    curve_beneath(const Handle(Geom_Curve) & curve, const Handle(Geom_Surface) & surface,
                  const Handle(Geom2d_Curve) & of_file, double low, double high, double tolerance)
{
    // Places at which the curve of the file is compared, chosen, and steps of Newton's method to
    // the nearest place: it doubles the digits, from 1e-3 to rounding.
    constexpr int samples = 100, steps = 3;
    const Ground ground(surface);
    bool is_near = true;
    for (int i = 0; i <= samples && is_near; ++i)
    {
        const double t = low + i * (high - low) / samples;
        const Vector2 uv = place_at(of_file, t);
        is_near =
            ground.step(uv, curve->Value(t)).cwiseProduct(ground.scale(uv)).norm() <= tolerance;
    }
    if (is_near)
        return of_file;
    const Vector2 scale = ground.scale(place_at(of_file, 0.5 * (low + high)));
    const auto beneath = [&](double t) -> Vector3
    {
        Vector2 uv = place_at(of_file, t);
        for (int step = 0; step < steps; ++step)
            uv += ground.step(uv, curve->Value(t));
        return (Vector3() << uv.cwiseProduct(scale), 0.0).finished();
    };
    const CubicBasis start(low, high, curve_breaks(curve, low, high));
    const SplineCurve found = curve_near(beneath, start, 0.2 * tolerance);
    return flat_spline(found.basis, found.poles.leftCols<2>() * scale.cwiseInverse().asDiagonal());
}

Handle(Geom_BSplineCurve)
    border_above(const Handle(Geom2d_Curve) & curve, const Handle(Geom_BSplineSurface) & surface,
                 double low, double high)
{
    // Relative to the length of the curve. Measured: a seam of an IGES file in inches was 4e-9
    // longer than its surface (OpenCASCADE 7.8).
    constexpr double exact = 1e-9, past = 1e-8;
    const Vector2 from = place_at(curve, low), to = place_at(curve, high);
    const double length = (to - from).norm();
    for (const double share : {0.2, 0.5, 0.9})
        if ((place_at(curve, low + share * (high - low)) - from - share * (to - from)).norm()
            > exact * length)
            return {};
    const int k = std::abs(to(0) - from(0)) < exact * length ? 0 : 1;
    if (!(length > 0.0) || std::abs(to(k) - from(k)) > exact * length)
        return {};
    const auto border = Handle(Geom_BSplineCurve)::DownCast(k == 0 ? surface->UIso(from(0))
                                                                   : surface->VIso(from(1)));
    if (border.IsNull())
        return {};
    // The curve may run past the end of the surface by what a file rounds; a segment may not.
    const double start = border->FirstParameter(), end = border->LastParameter();
    const double first = std::max(std::min(from(1 - k), to(1 - k)), start);
    const double last = std::min(std::max(from(1 - k), to(1 - k)), end);
    if (last - first < (1.0 - past) * length)
        return {};
    border->Segment(first, last);
    if (to(1 - k) < from(1 - k))
        border->Reverse();
    TColStd_Array1OfReal knots(1, border->NbKnots());
    border->Knots(knots);
    BSplCLib::Reparametrize(low, high, knots);
    border->SetKnots(knots);
    return border;
}

Handle(Geom2d_BSplineCurve) flat_spline(const CubicBasis& basis, const Eigen::MatrixXd& poles)
{
    TColgp_Array1OfPnt2d points(1, basis.count());
    for (int k = 0; k < basis.count(); ++k)
        points.SetValue(k + 1, {poles(k, 0), poles(k, 1)});
    const std::vector<double>& ends = basis.ends();
    const std::vector<double>& all = basis.knots();
    TColStd_Array1OfReal at(1, static_cast<int>(ends.size()));
    TColStd_Array1OfInteger times(1, at.Length());
    for (int k = 1; k <= at.Length(); ++k)
    {
        const double end = ends[static_cast<std::size_t>(k - 1)];
        at.SetValue(k, end);
        times.SetValue(k, static_cast<int>(std::count(all.begin(), all.end(), end)));
    }
    return new Geom2d_BSplineCurve(points, at, times, 3);
}

}  // namespace sheetmorph::cad

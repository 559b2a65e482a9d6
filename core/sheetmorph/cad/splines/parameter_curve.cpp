// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/parameter_curve.h"
#include "sheetmorph/cad/splines/spline_curve.h"
#include "sheetmorph/cad/splines/surface_breaks.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <gp_Vec.hxx>

namespace sheetmorph
{

namespace
{

// A spline in two parameters of one in space whose third coordinate is 0; how long their units are.
Handle(Geom2d_Curve) flat(const SplineCurve& spline, const Vector2& scale)
{
    const Handle(Geom_BSplineCurve) curve = spline.curve();
    TColgp_Array1OfPnt2d points(1, curve->NbPoles());
    TColStd_Array1OfReal at(1, curve->NbKnots());
    TColStd_Array1OfInteger times(1, curve->NbKnots());
    for (int k = 1; k <= points.Length(); ++k)
        points.SetValue(k, {curve->Pole(k).X() / scale(0), curve->Pole(k).Y() / scale(1)});
    curve->Knots(at);
    curve->Multiplicities(times);
    return new Geom2d_BSplineCurve(points, at, times, 3);
}

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

// A surface with the ends of its parameters.
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

    //! The step from parameters to those beneath a point, to first order; none at a pole.
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

    //! mm a unit of each parameter.
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
    if (Geom2dAdaptor_Curve(curve).GetType() == GeomAbs_Line)  // a trimmed one, too
        return line(curve->Value(low), curve->Value(high), low, high);
    constexpr double exact = 1e-6;
    const auto place = [&](double t) -> Vector3
    { return (Vector3() << place_at(curve, t), 0.0).finished(); };
    return flat(curve_near(place, CubicBasis(low, high), exact), Vector2::Ones());
}

Handle(Geom2d_Curve)
    curve_beneath(const Handle(Geom_Curve) & curve, const Handle(Geom_Surface) & surface,
                  const Handle(Geom2d_Curve) & of_file, double low, double high, double tolerance)
{
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
    return flat(curve_near(beneath, start, 0.2 * tolerance), scale);
}

}  // namespace sheetmorph

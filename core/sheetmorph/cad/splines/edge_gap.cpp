// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/edge_gap.h"
#include "sheetmorph/cad/meshing/occt_surface.h"
#include "sheetmorph/cad/splines/cubic_basis.h"
#include "sheetmorph/cad/splines/parameter_curve.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Vec.hxx>

namespace sheetmorph::cad
{

namespace
{

// Pieces between the places at which the reader measures. From OpenCASCADE, which measures the gap
// of an edge at 23 evenly spaced places.
constexpr int reader_pieces = 22;

// Share that the reader adds to what it measures; from OpenCASCADE, as reader_pieces.
constexpr double reader_slack = 0.5e-5;

// Width of a wave over the length of a piece, from the widest to the narrowest.
constexpr std::array<double, 4> widths = {0.4, 0.2, 0.1, 0.05};

Vector2 place_at(const Handle(Geom2d_Curve) & curve, double t)
{
    const gp_Pnt2d uv = curve->Value(t);
    return {uv.X(), uv.Y()};
}

// The cubic B-spline with knots at -2, -1, 0, 1 and 2, divided by its value at 0.
double bump(double x)
{
    const double a = std::abs(x);
    if (a >= 2.0)
        return 0.0;
    return a < 1.0 ? 1.0 - 1.5 * a * a + 0.75 * a * a * a : 0.25 * std::pow(2.0 - a, 3.0);
}

// The basis of a curve with further knots.
CubicBasis refined(const Handle(Geom2d_BSplineCurve) & curve, double centre, double width)
{
    std::vector<CubicBasis::Break> breaks;
    const int times = 3 - curve->Degree();  // a straight line has kinks at its knots
    for (int k = 2; k < curve->NbKnots(); ++k)
        breaks.push_back({curve->Knot(k), curve->Multiplicity(k) + times});
    for (int k = -3; k <= 3; ++k)
    {
        const double at = centre + k * width;
        if (std::none_of(breaks.begin(), breaks.end(),
                         [&](const CubicBasis::Break& one)
                         { return std::abs(one.at - at) < 1e-6 * width; }))
            breaks.push_back({at, 1});
    }
    std::sort(breaks.begin(), breaks.end(),
              [](const CubicBasis::Break& one, const CubicBasis::Break& other)
              { return one.at < other.at; });
    return {curve->FirstParameter(), curve->LastParameter(), breaks};
}

}  // namespace

//! b(x) + slope (b(x - 1) - b(x + 1)), with x from the centre in widths.
struct EdgeGap::Wave
{
    double centre, width;
    Vector2 way;  // in parameters, for height 1
    double height = 0.0, slope = 0.0;

    Vector2 at(double t) const
    {
        const double x = (t - centre) / width;
        return (height * bump(x) + slope * (bump(x - 1.0) - bump(x + 1.0))) * way;
    }
};

EdgeGap::EdgeGap(const Handle(Geom_Curve) & curve, const Handle(Geom_Surface) & surface, double low,
                 double high)
    : curve_(curve), surface_(surface), low_(low), high_(high)
{
}

Vector3 EdgeGap::at(const Handle(Geom2d_Curve) & beneath, double t) const
{
    const gp_Pnt2d uv = beneath->Value(t);
    return to_vector(surface_->Value(uv.X(), uv.Y()).XYZ() - curve_->Value(t).XYZ());
}

double EdgeGap::largest(const Handle(Geom2d_Curve) & beneath) const
{
    // Chosen: 30 places between two of the reader's; a gap on a cubic span has at most three
    // extrema.
    constexpr int samples = 30 * reader_pieces, samples_a_span = 8;
    double found = 0.0;
    const auto look = [&](double low, double high, int count)
    {
        for (int i = 0; i <= count; ++i)
            found = std::max(found, at(beneath, low + i * (high - low) / count).norm());
    };
    look(low_, high_, samples);
    // The curve has short spans where the gap changes quickly.
    if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(beneath); !spline.IsNull())
        for (int k = 1; k < spline->NbKnots(); ++k)
            look(spline->Knot(k), spline->Knot(k + 1), samples_a_span);
    return found;
}

// 1 mm along the surface at right angles to the edge, in parameters, towards the side with more
// surface.
Vector2 EdgeGap::across(const Vector2& uv, double t) const
{
    gp_Pnt here;
    gp_Vec u, v, along;
    surface_->D1(uv(0), uv(1), here, u, v);
    curve_->D1(t, here, along);
    const gp_Vec out = u.Crossed(v).Crossed(along);
    const double uu = u.Dot(u), vv = v.Dot(v), mixed = u.Dot(v);
    const double squared = uu * vv - mixed * mixed;
    if (!(squared > 1e-6 * uu * vv) || !(out.Magnitude() > 0.0))
        return Vector2::Zero();
    const Vector2 way =
        Vector2(vv * u.Dot(out) - mixed * v.Dot(out), uu * v.Dot(out) - mixed * u.Dot(out))
        / (squared * out.Magnitude());
    Vector2 low, high;
    surface_->Bounds(low(0), high(0), low(1), high(1));
    const Vector2 middle = 0.5 * (low + high);
    return (middle - uv).cwiseQuotient(high - low).dot(way.cwiseQuotient(high - low)) < 0.0
               ? Vector2(-way)
               : way;
}

Handle(Geom2d_BSplineCurve) EdgeGap::added(const Handle(Geom2d_BSplineCurve) & beneath,
                                           const Wave& wave) const
{
    const CubicBasis basis = refined(beneath, wave.centre, wave.width);
    const std::vector<double> places = basis.greville();
    Eigen::MatrixXd values(static_cast<Eigen::Index>(places.size()), 2);
    for (std::size_t i = 0; i < places.size(); ++i)
        values.row(static_cast<Eigen::Index>(i)) =
            (place_at(beneath, places[i]) + wave.at(places[i])).transpose();
    return flat_spline(basis, basis.through(places, values));
}

// Newton's method for height and slope: at the centre, the gap has the prescribed length and is
// largest.
Handle(Geom2d_BSplineCurve) EdgeGap::fitted(const Handle(Geom2d_BSplineCurve) & beneath, Wave wave,
                                            double largest) const
{
    // Newton's method doubles the digits per round. Chosen: after 12 it does not converge at all.
    // The steps of its differences are a thousandth of the wave: their error is the square, 1e-6.
    constexpr int most_rounds = 12;
    const double step = 1e-3 * wave.width;
    const auto miss = [&](const Wave& one) -> Vector2
    {
        const auto squared = [&](double t)
        {
            const Vector2 uv = place_at(beneath, t) + one.at(t);
            return (to_vector(surface_->Value(uv(0), uv(1)).XYZ() - curve_->Value(t).XYZ())
                    / largest)
                .squaredNorm();
        };
        const double before = squared(one.centre - step), after = squared(one.centre + step);
        return {squared(one.centre) - 1.0, (after - before) * wave.width / (2.0 * step)};
    };
    for (int round = 0; round < most_rounds; ++round)
    {
        const Vector2 now = miss(wave);
        if (now.cwiseAbs().maxCoeff() < 1e-7)
            break;
        const double change = 1e-3 * largest;
        Wave higher = wave, steeper = wave;
        higher.height += change;
        steeper.slope += change;
        Eigen::Matrix2d system;
        system << miss(higher) - now, miss(steeper) - now;
        const Vector2 found = change * system.fullPivLu().solve(now);
        wave.height -= found(0);
        wave.slope -= found(1);
    }
    const bool is_sound =
        std::abs(wave.height) < 3.0 * largest && std::abs(wave.slope) < std::abs(wave.height);
    return is_sound ? added(beneath, wave) : beneath;
}

Handle(Geom2d_BSplineCurve) EdgeGap::with_wave(const Handle(Geom2d_BSplineCurve) & beneath,
                                               double largest) const
{
    const double piece = (high_ - low_) / reader_pieces;
    std::vector<std::pair<double, double>> places;  // largest gap first
    for (int i = 1; i < reader_pieces; ++i)
        places.emplace_back(-at(beneath, low_ + i * piece).norm(), low_ + i * piece);
    std::sort(places.begin(), places.end());
    places.resize(4);
    for (const double width : widths)
        for (const auto& [before, place] : places)
        {
            if (std::min(place - low_, high_ - place) <= 3.0 * width * piece)
                continue;
            Wave wave{place, width * piece, across(place_at(beneath, place), place)};
            wave.height = std::sqrt(std::max(0.0, largest * largest - before * before));
            const Handle(Geom2d_BSplineCurve) found = fitted(beneath, wave, largest);
            const double there = at(found, place).norm();
            if (there > (1.0 - 1e-4) * largest
                && this->largest(found) <= (1.0 + reader_slack) * there)
                return found;
        }
    return beneath;
}

}  // namespace sheetmorph::cad

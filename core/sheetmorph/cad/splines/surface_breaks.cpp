// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/surface_breaks.h"
#include "sheetmorph/cad/meshing/occt_surface.h"

#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <array>
#include <functional>

namespace sheetmorph::cad
{

namespace
{

// First and second derivatives at some places with respect to one parameter, one row per place.
using Slopes = std::array<Points, 2>;
using SlopesAt = std::function<Slopes(double)>;

// Multiplicity of a knot. Where a CAD system extended a surface or joined two smoothly, files have
// knots of higher multiplicity than needed, and a surface with needless freedom swings.
int times_at(const SlopesAt& slopes, double at, double range)
{
    // Distance from the knot, relative to the range, and jumps of slope and curvature, relative to
    // the speed. From rounding: knots have ten digits or more, and slopes near them are exact to
    // 1e-9. Chosen: a kink of 1e-5 radians and a bend of 1e-3 do not show.
    constexpr double beside = 1e-9, kink = 1e-5, bend = 1e-3;
    const Slopes before = slopes(at - beside * range), after = slopes(at + beside * range);
    const auto largest = [](const Points& rows) { return rows.rowwise().norm().maxCoeff(); };
    const double speed = std::max(largest(before[0]), largest(after[0]));
    if (largest(after[0] - before[0]) > kink * speed)
        return 3;
    return largest(after[1] - before[1]) * range > bend * speed ? 2 : 0;
}

// The places inside the range that need a knot: with a kink, or without a continuous second
// derivative.
std::vector<CubicBasis::Break> real_breaks(std::vector<double> places, const SlopesAt& slopes,
                                           double low, double high)
{
    const double least = 1e-6 * (high - low);
    std::vector<CubicBasis::Break> found;
    std::sort(places.begin(), places.end());
    for (const double at : places)
    {
        if (at < low + least || at > high - least
            || (!found.empty() && at < found.back().at + least))
            continue;
        if (const int times = times_at(slopes, at, high - low); times > 0)
            found.push_back({at, times});
    }
    return found;
}

std::vector<double> as_vector(const TColStd_Array1OfReal& values)
{
    return {values.begin(), values.end()};
}

}  // namespace

std::vector<CubicBasis::Break> surface_breaks(const SurfacePatch& patch, int direction)
{
    const GeomAdaptor_Surface surface(patch.surface, patch.low(0), patch.high(0), patch.low(1),
                                      patch.high(1));
    TColStd_Array1OfReal ends(
        1,
        1 + (direction == 0 ? surface.NbUIntervals(GeomAbs_C2) : surface.NbVIntervals(GeomAbs_C2)));
    if (direction == 0)
        surface.UIntervals(ends, GeomAbs_C2);
    else
        surface.VIntervals(ends, GeomAbs_C2);
    const auto slopes = [&](double at)
    {
        constexpr int samples = 8;  // chosen: a knot of a whole row shows at nine places
        const int other = 1 - direction;
        Slopes found = {Points(samples + 1, 3), Points(samples + 1, 3)};
        for (int i = 0; i <= samples; ++i)
        {
            const double beside =
                patch.low(other) + i * (patch.high(other) - patch.low(other)) / samples;
            gp_Pnt here;
            gp_Vec u, v, uu, vv, uv;
            patch.surface->D2(direction == 0 ? at : beside, direction == 0 ? beside : at, here, u,
                              v, uu, vv, uv);
            found[0].row(i) = to_vector((direction == 0 ? u : v).XYZ()).transpose();
            found[1].row(i) = to_vector((direction == 0 ? uu : vv).XYZ()).transpose();
        }
        return found;
    };
    return real_breaks(as_vector(ends), slopes, patch.low(direction), patch.high(direction));
}

std::vector<CubicBasis::Break> curve_breaks(const Handle(Geom_Curve) & curve, double low,
                                            double high)
{
    const GeomAdaptor_Curve adaptor(curve, low, high);
    TColStd_Array1OfReal ends(1, 1 + adaptor.NbIntervals(GeomAbs_C2));
    adaptor.Intervals(ends, GeomAbs_C2);
    const auto slopes = [&](double at)
    {
        gp_Pnt here;
        gp_Vec first, second;
        curve->D2(at, here, first, second);
        return Slopes{Points(to_vector(first.XYZ()).transpose()),
                      Points(to_vector(second.XYZ()).transpose())};
    };
    return real_breaks(as_vector(ends), slopes, low, high);
}

}  // namespace sheetmorph::cad

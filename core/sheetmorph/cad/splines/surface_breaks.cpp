// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/surface_breaks.h"

#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

// What has one continuous derivative only between places, and two only between more of them.
std::vector<CubicBasis::Break> merged(const std::vector<double>& kinks,
                                      const std::vector<double>& breaks, double low, double high)
{
    const double least = 1e-6 * (high - low);
    std::vector<CubicBasis::Break> found;
    const auto add = [&](double at, int times)
    {
        if (at < low + least || at > high - least)
            return;
        for (const CubicBasis::Break& one : found)
            if (std::abs(one.at - at) < least)
                return;
        found.push_back({at, times});
    };
    for (const double at : kinks)
        add(at, 3);
    for (const double at : breaks)
        add(at, 2);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
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
    const auto ends = [&](GeomAbs_Shape shape)
    {
        TColStd_Array1OfReal found(
            1, 1 + (direction == 0 ? surface.NbUIntervals(shape) : surface.NbVIntervals(shape)));
        if (direction == 0)
            surface.UIntervals(found, shape);
        else
            surface.VIntervals(found, shape);
        return as_vector(found);
    };
    return merged(ends(GeomAbs_C1), ends(GeomAbs_C2), patch.low(direction), patch.high(direction));
}

std::vector<CubicBasis::Break> curve_breaks(const Handle(Geom_Curve) & curve, double low,
                                            double high)
{
    const GeomAdaptor_Curve adaptor(curve, low, high);
    const auto ends = [&](GeomAbs_Shape shape)
    {
        TColStd_Array1OfReal found(1, 1 + adaptor.NbIntervals(shape));
        adaptor.Intervals(found, shape);
        return as_vector(found);
    };
    return merged(ends(GeomAbs_C1), ends(GeomAbs_C2), low, high);
}

}  // namespace sheetmorph

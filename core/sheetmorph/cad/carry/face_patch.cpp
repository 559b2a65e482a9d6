// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/face_patch.h"
#include "sheetmorph/cad/meshing/occt_surface.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

Vector3 point_at(const Handle(Geom_Surface) & surface, double u, double v)
{
    return to_vector(surface->Value(u, v).XYZ());
}

// Largest distance between two opposite borders, which is 0 for one curve, mm.
double distance_across(const SurfacePatch& patch, int direction)
{
    constexpr int samples = 8;  // chosen: two different borders agree at nine places by chance only
    double worst = 0.0;
    for (int i = 0; i <= samples; ++i)
    {
        Vector2 low = patch.low, high = patch.high;
        low(1 - direction) = high(1 - direction) =
            patch.low(1 - direction)
            + i * (patch.high(1 - direction) - patch.low(1 - direction)) / samples;
        worst = std::max(worst, (point_at(patch.surface, low(0), low(1))
                                 - point_at(patch.surface, high(0), high(1)))
                                    .norm());
    }
    return worst;
}

// Whether the borders of a patch on one of its sides cover that side completely.
bool is_along(const SurfacePatch& patch, const FaceBorder& border, int direction, double at)
{
    const double range = patch.high(direction) - patch.low(direction);
    for (const double share : {0.0, 0.5, 1.0})
    {
        const gp_Pnt2d uv = border.curve->Value(border.low + share * (border.high - border.low));
        if (std::abs((direction == 0 ? uv.X() : uv.Y()) - at) > 1e-7 * range)
            return false;
    }
    return true;
}

// Cuts the patch to the extent of a bounded surface.
void keep_inside(SurfacePatch& patch)
{
    double low_u = 0.0, high_u = 0.0, low_v = 0.0, high_v = 0.0;
    patch.surface->Bounds(low_u, high_u, low_v, high_v);
    const Vector2 low(low_u, low_v), high(high_u, high_v);
    const std::array<bool, 2> is_periodic = {patch.surface->IsUPeriodic(),
                                             patch.surface->IsVPeriodic()};
    for (int k = 0; k < 2; ++k)
        if (!is_periodic[static_cast<std::size_t>(k)])
        {
            patch.low(k) = std::max(patch.low(k), low(k));
            patch.high(k) = std::min(patch.high(k), high(k));
        }
}

// Sets the patch to the box around borders. \returns whether they are straight
bool put_around(SurfacePatch& patch, const std::vector<FaceBorder>& borders)
{
    patch.low.setConstant(1e300);
    patch.high.setConstant(-1e300);
    bool is_straight = true;
    for (const FaceBorder& border : borders)
    {
        // Chosen: between samples, an arc leaves their box by 1 - cos(2 pi / 128), 0.1 % at most.
        constexpr int samples = 64;
        for (int i = 0; i <= samples; ++i)
        {
            const gp_Pnt2d uv =
                border.curve->Value(border.low + i * (border.high - border.low) / samples);
            patch.low = patch.low.cwiseMin(Vector2(uv.X(), uv.Y()));
            patch.high = patch.high.cwiseMax(Vector2(uv.X(), uv.Y()));
        }
        is_straight = is_straight && Geom2dAdaptor_Curve(border.curve).GetType() == GeomAbs_Line;
    }
    return is_straight;
}

using Ranges = std::vector<std::pair<double, double>>;

// The ranges of each side that borders cover. A side that is one point in space becomes a pole.
std::array<Ranges, 4> borders_along(SurfacePatch& patch, const std::vector<FaceBorder>& borders)
{
    std::array<Ranges, 4> along;
    for (std::size_t side = 0; side < 4; ++side)
        for (const FaceBorder& border : borders)
        {
            const int k = static_cast<int>(side / 2);
            const double at = side % 2 == 0 ? patch.low(k) : patch.high(k);
            if (!is_along(patch, border, k, at))
                continue;
            const gp_Pnt2d one = border.curve->Value(border.low),
                           other = border.curve->Value(border.high);
            along[side].push_back(k == 0 ? std::minmax({one.Y(), other.Y()})
                                         : std::minmax({one.X(), other.X()}));
            patch.is_pole[side] = patch.is_pole[side] || border.is_degenerated;
        }
    return along;
}

// Whether both sides have a border at the same place. A strip that winds around a cylinder has
// borders on both sides, but never opposite each other.
bool has_seam(const Ranges& low, const Ranges& high, double least)
{
    for (const auto& one : low)
        for (const auto& other : high)
            if (std::min(one.second, other.second) - std::max(one.first, other.first) > least)
                return true;
    return false;
}

// Adds the knots of a curve that must lie on a straight border along which one parameter changes.
void add_knots(const FaceBorder& border, SurfacePatch& patch)
{
    // Share of a border across which its parameter stays constant. From rounding of parameters
    // (1e-16) and from files with ten digits.
    constexpr double exact = 1e-9;
    const Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(border.target);
    if (spline.IsNull() || Geom2dAdaptor_Curve(border.curve).GetType() != GeomAbs_Line)
        return;
    const gp_Pnt2d from = border.curve->Value(border.low), to = border.curve->Value(border.high);
    const Vector2 way(to.X() - from.X(), to.Y() - from.Y());
    for (int k = 0; k < 2; ++k)
        for (int i = 2; i < spline->NbKnots() && std::abs(way(1 - k)) < exact * way.norm(); ++i)
        {
            const double spacing = std::min(spline->Knot(i) - spline->Knot(i - 1),
                                            spline->Knot(i + 1) - spline->Knot(i));
            patch.knots[static_cast<std::size_t>(k)].push_back(
                {border.curve->Value(spline->Knot(i)).Coord(k + 1),
                 spacing * way.norm() / (border.high - border.low)});
        }
}

}  // namespace

SurfacePatch surface_patch(const Handle(Geom_Surface) & surface,
                           const std::vector<FaceBorder>& borders)
{
    SurfacePatch patch;
    patch.surface = surface;
    for (const FaceBorder& border : borders)
        add_knots(border, patch);
    const bool is_straight = put_around(patch, borders);
    const std::array<Ranges, 4> along = borders_along(patch, borders);
    const Vector2 middle = 0.5 * (patch.low + patch.high);
    const double size =
        (point_at(surface, patch.low(0), patch.low(1)) - point_at(surface, middle(0), middle(1)))
            .norm();
    for (int k = 0; k < 2; ++k)
    {
        const auto side = static_cast<std::size_t>(2 * k);
        const double least = 1e-6 * (patch.high(1 - k) - patch.low(1 - k));
        patch.is_closed[static_cast<std::size_t>(k)] = has_seam(along[side], along[side + 1], least)
                                                       && distance_across(patch, k) < 1e-4 * size;
    }
    if (is_straight)
        return patch;
    const Vector2 more = 0.002 * (patch.high - patch.low);
    for (int k = 0; k < 2; ++k)
    {
        const auto side = static_cast<std::size_t>(2 * k);
        if (along[side].empty())
            patch.low(k) -= more(k);
        if (along[side + 1].empty())
            patch.high(k) += more(k);
    }
    keep_inside(patch);
    return patch;
}

}  // namespace sheetmorph::cad

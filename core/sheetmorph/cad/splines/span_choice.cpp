// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/span_choice.h"
#include "sheetmorph/cad/meshing/occt_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

// Chosen to limit time and files: 250,000 poles are estimated at 20 MB of STEP.
constexpr int most_spans = 800, most_poles = 250000;
// Where the surface is off by more than `far` tolerances, spans may be as short as this share of
// the usual limit. Chosen: below, a written edge is still within twice its tolerance.
constexpr double far = 1.8, shortest = 0.25;
// Smaller kinks are accepted, radians. From the promise to the user, below 0.1 degrees: half of it.
constexpr double most_angle = 9e-4;

}  // namespace

SpanChoice::SpanChoice(const FaceSpline& spline, const std::vector<SurfacePlace>& places,
                       const std::vector<SurfaceNormal>& normals, double tolerance)
    : spline_(spline)
{
    chosen_[0].assign(static_cast<std::size_t>(spline.u_.span_count()), false);
    chosen_[1].assign(static_cast<std::size_t>(spline.v_.span_count()), false);
    choose_by_surface(tolerance);
    for (const SurfacePlace& place : places)
    {
        const double off = (spline.point(place.uv) - place.target).norm();
        if (off <= place.tolerance)
            continue;
        is_met_ = false;
        const bool is_far = off > far * place.tolerance;
        choose_at(place.uv, is_far ? shortest * place.spacing : place.spacing);
    }
    for (const SurfaceNormal& one : normals)
    {
        const Eigen::Matrix<double, 3, 2> tangents = spline.tangents(one.uv);
        const Vector3 normal = tangents.col(0).cross(tangents.col(1)).normalized();
        if (normal.cross(one.normal).norm() <= most_angle)
            continue;
        is_met_ = false;
        choose_at(one.uv, one.spacing);
    }
    const bool is_large = spline.u_.count() * spline.v_.count() > most_poles;
    for (std::vector<bool>& chosen : chosen_)
    {
        if (is_large || static_cast<int>(chosen.size()) > most_spans)
            std::fill(chosen.begin(), chosen.end(), false);
        is_any_ = is_any_ || std::find(chosen.begin(), chosen.end(), true) != chosen.end();
    }
}

double SpanChoice::length(int direction, int span) const
{
    const std::vector<double>& ends = (direction == 0 ? spline_.u_ : spline_.v_).ends();
    return spline_.scale_(direction)
           * (ends[static_cast<std::size_t>(span + 1)] - ends[static_cast<std::size_t>(span)]);
}

// Change of the displacement's second derivative over one span, mm.
double SpanChoice::change(const Vector2& uv, int direction) const
{
    const CubicBasis& basis = direction == 0 ? spline_.u_ : spline_.v_;
    const CubicBasis& other = direction == 0 ? spline_.v_ : spline_.u_;
    const auto span = static_cast<std::size_t>(basis.span_of(uv(direction)));
    const double low = basis.ends()[span], length = basis.ends()[span + 1] - low;
    const CubicBasis::Row beside = other.row(uv(1 - direction));
    const auto second = [&](double t)
    {
        const CubicBasis::Row row = basis.row(t, 2);
        Eigen::RowVector3d found = Eigen::RowVector3d::Zero();
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
            {
                const int a = row.first + i, b = beside.first + j;
                const int pole =
                    direction == 0 ? a * spline_.v_.count() + b : b * spline_.v_.count() + a;
                found += row.weights[static_cast<std::size_t>(i)]
                         * beside.weights[static_cast<std::size_t>(j)]
                         * (spline_.poles_.row(pole) - spline_.base_.row(pole));
            }
        return found;
    };
    return (second(low + 0.999 * length) - second(low + 0.001 * length)).norm() * length * length;
}

void SpanChoice::choose_at(const Vector2& uv, double spacing)
{
    const std::array<int, 2> span = {spline_.u_.span_of(uv(0)), spline_.v_.span_of(uv(1))};
    const std::array<double, 2> changes = {change(uv, 0), change(uv, 1)};
    for (int k = 0; k < 2; ++k)
    {
        const auto own = static_cast<std::size_t>(k), other = static_cast<std::size_t>(1 - k);
        const bool is_flat =
            5.0 * changes[own] < changes[other] && length(1 - k, span[other]) > 1.2 * spacing;
        if (!is_flat && length(k, span[own]) > 1.2 * spacing)
            chosen_[own][static_cast<std::size_t>(span[own])] = true;
    }
}

// At a pole of one parameter, the spans of the other one cause the error.
void SpanChoice::choose_by_surface(double tolerance)
{
    FaceSpline alone = spline_;
    alone.poles_ = spline_.base_;
    for (int k = 0; k < 2; ++k)
    {
        const CubicBasis& basis = k == 0 ? spline_.u_ : spline_.v_;
        const std::vector<double> beside = (k == 0 ? spline_.v_ : spline_.u_).greville();
        for (int span = 0; span < basis.span_count(); ++span)
            for (const double share : {0.2, 0.5, 0.8})
                for (const double other : beside)
                {
                    const auto i = static_cast<std::size_t>(span);
                    const double at =
                        basis.ends()[i] + share * (basis.ends()[i + 1] - basis.ends()[i]);
                    const Vector2 uv = k == 0 ? Vector2(at, other) : Vector2(other, at);
                    const gp_Pnt there = spline_.patch_.surface->Value(uv(0), uv(1));
                    if ((alone.point(uv) - to_vector(there.XYZ())).norm() > tolerance)
                        chosen_[static_cast<std::size_t>(k)][i] = true;
                }
    }
}

}  // namespace sheetmorph::cad

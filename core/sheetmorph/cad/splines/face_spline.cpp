// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/face_spline.h"
#include "sheetmorph/cad/meshing/occt_surface.h"
#include "sheetmorph/cad/splines/plate_system.h"
#include "sheetmorph/cad/splines/span_choice.h"
#include "sheetmorph/cad/splines/surface_breaks.h"

#include <Eigen/Geometry>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

// Weight of the energy of a thin plate, beside places of weight 1. Measured: with 1e-6, surfaces
// swing between places to meet edges better than they need to, and tangents across edges grew a
// hundredfold.
constexpr double plate_weight = 1e-4;
// Weights of a tangent that is off by 1 mm over one span, and of one across a seam. Chosen: a
// tangent counts as much as a hundred places (ten times as exact), and a seam, which must not show,
// thirty times as exact.
constexpr double tangent_weight = 100.0, seam_weight = 900.0;

Vector2 scale_of(const SurfacePatch& patch)
{
    constexpr int samples = 6;  // chosen: 49 places give the mean length of the parameters' lines
    Vector2 length = Vector2::Zero();
    for (int i = 0; i <= samples; ++i)
        for (int j = 0; j <= samples; ++j)
        {
            gp_Pnt point;
            gp_Vec along_u, along_v;
            const double u = patch.low(0) + i * (patch.high(0) - patch.low(0)) / samples;
            const double v = patch.low(1) + j * (patch.high(1) - patch.low(1)) / samples;
            patch.surface->D1(u, v, point, along_u, along_v);
            length += Vector2(along_u.Magnitude(), along_v.Magnitude());
        }
    length /= (samples + 1.0) * (samples + 1.0);
    return length.cwiseMax(1e-12);
}

// The knots of a surface and of curves on it, those with long spans first. Skips a knot so near to
// others that it would make long spans short.
CubicBasis basis_of(const SurfacePatch& patch, int direction)
{
    // Relative to the spacing of the knots of a curve. Chosen above a half: a knot in the middle
    // between two others would make spans half as long as theirs.
    constexpr double nearest = 0.6;
    const double low = patch.low(direction), high = patch.high(direction);
    std::vector<CubicBasis::Break> breaks = surface_breaks(patch, direction);
    std::vector<CurveKnot> knots = patch.knots[static_cast<std::size_t>(direction)];
    std::stable_sort(knots.begin(), knots.end(),
                     [](const CurveKnot& one, const CurveKnot& other)
                     { return one.spacing > other.spacing; });
    for (const CurveKnot& knot : knots)
    {
        const double least = nearest * knot.spacing;
        const bool is_apart = std::none_of(breaks.begin(), breaks.end(),
                                           [&](const CubicBasis::Break& one)
                                           { return std::abs(one.at - knot.at) < least; });
        if (is_apart && knot.at > low + least && knot.at < high - least)
            breaks.push_back({knot.at, 1});
    }
    std::sort(breaks.begin(), breaks.end(),
              [](const CubicBasis::Break& one, const CubicBasis::Break& other)
              { return one.at < other.at; });
    return {low, high, breaks};
}

// Products of a derivative of the splines of a basis, summed at two places of every span and
// weighted by its squared length.
PlateSystem::Band band_of(const CubicBasis& basis, int derivative)
{
    const double gauss = 0.5 / std::sqrt(3.0);
    PlateSystem::Band band(static_cast<std::size_t>(basis.count()));
    for (int span = 0; span < basis.span_count(); ++span)
    {
        const double low = basis.ends()[static_cast<std::size_t>(span)];
        const double length = basis.ends()[static_cast<std::size_t>(span + 1)] - low;
        for (const double share : {0.5 - gauss, 0.5 + gauss})
        {
            const CubicBasis::Row row = basis.row(low + share * length, derivative);
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t k = 0; k < 4; ++k)
                    band[static_cast<std::size_t>(row.first) + i][k + 3 - i] +=
                        length * length * row.weights[i] * row.weights[k];
        }
    }
    return band;
}

// Adds the energy of a thin plate, in which a long span counts by its square.
void add_plate(PlateSystem& system, const CubicBasis& u, const CubicBasis& v, const Vector2& scale)
{
    const double in_u = scale(0) * scale(0), in_v = scale(1) * scale(1);
    const double weight = 0.25 * plate_weight * in_u * in_v;
    system.add_energy(band_of(u, 2), band_of(v, 0), weight / (in_u * in_u));
    system.add_energy(band_of(u, 1), band_of(v, 1), 2.0 * weight / (in_u * in_v));
    system.add_energy(band_of(u, 0), band_of(v, 2), weight / (in_v * in_v));
}

}  // namespace

FaceSpline::FaceSpline(const SurfacePatch& patch)
    : patch_(patch), u_(basis_of(patch, 0)), v_(basis_of(patch, 1)), scale_(scale_of(patch))
{
    interpolate();
    poles_ = base_;
}

void FaceSpline::interpolate()
{
    const std::vector<double> in_u = u_.greville(), in_v = v_.greville();
    const int rows = u_.count(), columns = v_.count();
    Eigen::MatrixXd values(rows, 3 * columns);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
        {
            const gp_Pnt point = patch_.surface->Value(in_u[static_cast<std::size_t>(i)],
                                                       in_v[static_cast<std::size_t>(j)]);
            values.block<1, 3>(i, 3 * j) = to_vector(point.XYZ()).transpose();
        }
    const Eigen::MatrixXd across = u_.through(in_u, values);
    Eigen::MatrixXd turned(columns, 3 * rows);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            turned.block<1, 3>(j, 3 * i) = across.block<1, 3>(i, 3 * j);
    const Eigen::MatrixXd poles = v_.through(in_v, turned);
    base_.resize(rows * columns, 3);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            base_.row(i * columns + j) = poles.block<1, 3>(j, 3 * i);
}

void FaceSpline::fit(const SplineTargets& targets, double tolerance, const Progress& progress)
{
    // A round halves the spans where the surface is off. Chosen: 12 halvings divide them by 4096;
    // the limits of SpanChoice end earlier.
    constexpr int most_rounds = 12;
    const FaceSpline before = *this;
    for (int round = 0;; ++round)
    {
        progress.report(static_cast<double>(round) / (most_rounds + 1), "fitting");
        std::vector<SurfacePlace> places = targets.places;
        std::vector<SurfaceNormal> normals;
        for (const SurfaceTrack& track : targets.tracks)
        {
            add_places(track, places);
            if (track.normal)
                add_normals(track, normals);
        }
        if (round == 0 && SpanChoice(*this, places, normals, tolerance).is_met())
            return;
        interpolate();
        solve(places, normals, before);
        if (round == most_rounds)
            return;
        const SpanChoice choice(*this, places, normals, tolerance);
        if (!choice.is_any())
            return;
        u_ = u_.halved(choice.in_u());
        v_ = v_.halved(choice.in_v());
    }
}

// Number of spans of both parameters that a line between two places crosses.
double FaceSpline::spans_between(const Vector2& here, const Vector2& there) const
{
    double spans = 0.0;
    for (int k = 0; k < 2; ++k)
    {
        const CubicBasis& basis = k == 0 ? u_ : v_;
        double shortest = basis.high() - basis.low();
        for (const Vector2& uv : {here, there, Vector2(0.5 * (here + there))})
        {
            const auto span = static_cast<std::size_t>(basis.span_of(uv(k)));
            shortest = std::min(shortest, basis.ends()[span + 1] - basis.ends()[span]);
        }
        spans += std::abs(there(k) - here(k)) / shortest;
    }
    return spans;
}

// Adds enough places that a surface cannot swing between them, however short its spans are.
void FaceSpline::add_places(const SurfaceTrack& track, std::vector<SurfacePlace>& places) const
{
    // Weights beside mesh vertices (1), places to a span, and the shortest span as a share of the
    // spacing. Measured with a prototype on real parts: 30 along an edge, 3000 at its ends, 2.5 and
    // 0.15. Since then, more weight along edges lets faces meet closer at corners, and more places
    // keep surfaces from swinging between them.
    constexpr double along = 60.0, at_end = 1000.0, to_a_span = 6.0, spacing_share = 0.15;
    // Of the distance between places. Chosen: nearer places are the same.
    constexpr double closest = 0.01;
    constexpr int least = 6, most = 80;  // places on a piece of an edge; chosen to limit the time
    const std::size_t pieces = track.parameters.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i)
    {
        const double low = track.parameters[i], high = track.parameters[i + 1];
        const Vector2 here = track.uv(low), there = track.uv(high);
        const int cuts =
            std::clamp(static_cast<int>(to_a_span * spans_between(here, there)) + 1, least, most);
        const double length = (track.target(low) - track.target(high)).norm();
        const auto add = [&](double cut, bool is_end)
        {
            const double t = low + cut * (high - low) / cuts;
            places.push_back({track.uv(t), track.target(t),
                              is_end || track.is_point ? at_end : along, track.tolerance,
                              spacing_share * length});
        };
        for (int cut = 0; cut < cuts + (i + 1 == pieces ? 1 : 0); ++cut)
            add(cut, (i == 0 && cut == 0) || cut == cuts);
        // Near a corner, spans may be as short as the edge beyond it requires.
        for (double near = 0.5; near > closest; near *= 0.5)
        {
            if (i == 0)
                add(near, false);
            if (i + 1 == pieces)
                add(cuts - near, false);
        }
    }
}

// The same for normals. Between few of them, a surface that meets all might still be steep.
void FaceSpline::add_normals(const SurfaceTrack& track, std::vector<SurfaceNormal>& normals) const
{
    // Chosen: half as many as places, because a normal prescribes two numbers and changes more
    // slowly.
    constexpr double to_a_span = 1.0, spacing_share = 0.5;
    constexpr int least = 4, most = 40;
    const std::size_t pieces = track.parameters.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i)
    {
        const double low = track.parameters[i], high = track.parameters[i + 1];
        const int cuts = std::clamp(
            static_cast<int>(to_a_span * spans_between(track.uv(low), track.uv(high))) + 1, least,
            most);
        const double length = (track.target(low) - track.target(high)).norm();
        for (int cut = 0; cut < cuts + (i + 1 == pieces ? 1 : 0); ++cut)
        {
            const double t = low + cut * (high - low) / cuts;
            if (const Vector3 normal = track.normal(t); normal.norm() > 0.5)
                normals.push_back({track.uv(t), normal, static_cast<double>(least) / cuts,
                                   spacing_share * length});
        }
    }
}

void FaceSpline::solve(const std::vector<SurfacePlace>& places,
                       const std::vector<SurfaceNormal>& normals, const FaceSpline& before)
{
    PlateSystem system(u_.count(), v_.count());
    poles_ = base_;
    for (const SurfacePlace& place : places)
        system.add(u_.row(place.uv(0)), v_.row(place.uv(1)), place.target - point(place.uv),
                   place.weight * place.weight);
    for (const SurfaceNormal& one : normals)
    {
        const Eigen::Matrix<double, 3, 2> wrong = before.tangents(one.uv), own = tangents(one.uv);
        for (int k = 0; k < 2; ++k)
        {
            const CubicBasis& basis = k == 0 ? u_ : v_;
            const auto span = static_cast<std::size_t>(basis.span_of(one.uv(k)));
            const double length = basis.ends()[span + 1] - basis.ends()[span];
            const Vector3 wanted = wrong.col(k) - one.normal * one.normal.dot(wrong.col(k));
            system.add(u_.row(one.uv(0), k == 0 ? 1 : 0), v_.row(one.uv(1), k == 1 ? 1 : 0),
                       wanted - own.col(k), one.weight * tangent_weight * length * length);
        }
    }
    tie_seams(system);
    add_plate(system, u_, v_, scale_);
    poles_ = base_ + system.solution();
    close();
}

// A surface is as smooth across a seam as elsewhere, even if its face lies only on one side.
void FaceSpline::tie_seams(PlateSystem& system) const
{
    for (int k = 0; k < 2; ++k)
        if (patch_.is_closed[static_cast<std::size_t>(k)])
        {
            const CubicBasis &across = k == 0 ? u_ : v_, &along = k == 0 ? v_ : u_;
            const double length = across.ends()[1] - across.ends()[0];
            for (const double place : along.greville())
            {
                const CubicBasis::Row here = along.row(place);
                const auto tie = [&](int derivative, double weight)
                {
                    const auto ordered = [&](double end) -> std::array<CubicBasis::Row, 2>
                    {
                        const CubicBasis::Row row = across.row(end, derivative);
                        return k == 0 ? std::array{row, here} : std::array{here, row};
                    };
                    system.tie(ordered(across.low()), ordered(across.high()), k, weight);
                };
                tie(0, seam_weight);
                tie(1, seam_weight * length * length);
            }
        }
}

// Closes poles and seams exactly; least squares leave them almost closed.
void FaceSpline::close()
{
    const int rows = u_.count(), columns = v_.count();
    const auto pole = [&](int side, int place)
    {
        return side == 0   ? place
               : side == 1 ? (rows - 1) * columns + place
               : side == 2 ? place * columns
                           : place * columns + columns - 1;
    };
    for (int side = 0; side < 4; ++side)
    {
        const int along = side < 2 ? columns : rows;
        if (patch_.is_closed[static_cast<std::size_t>(side / 2)] && side % 2 == 0)
            for (int i = 0; i < along; ++i)
            {
                const Eigen::RowVector3d middle =
                    0.5 * (poles_.row(pole(side, i)) + poles_.row(pole(side + 1, i)));
                poles_.row(pole(side, i)) = poles_.row(pole(side + 1, i)) = middle;
            }
    }
    for (int side = 0; side < 4; ++side)
        if (patch_.is_pole[static_cast<std::size_t>(side)])
        {
            const int along = side < 2 ? columns : rows;
            Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
            for (int i = 0; i < along; ++i)
                middle += poles_.row(pole(side, i)) / along;
            for (int i = 0; i < along; ++i)
                poles_.row(pole(side, i)) = middle;
        }
}

void FaceSpline::round_to(double grain)
{
    poles_ = grain * (poles_ / grain).array().round();
}

Vector3 FaceSpline::sum(const CubicBasis::Row& u, const CubicBasis::Row& v) const
{
    Vector3 found = Vector3::Zero();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            found += u.weights[static_cast<std::size_t>(i)] * v.weights[static_cast<std::size_t>(j)]
                     * poles_.row((u.first + i) * v_.count() + v.first + j).transpose();
    return found;
}

Vector3 FaceSpline::point(const Vector2& uv) const
{
    return sum(u_.row(uv(0)), v_.row(uv(1)));
}

Eigen::Matrix<double, 3, 2> FaceSpline::tangents(const Vector2& uv) const
{
    Eigen::Matrix<double, 3, 2> found;
    found.col(0) = sum(u_.row(uv(0), 1), v_.row(uv(1)));
    found.col(1) = sum(u_.row(uv(0)), v_.row(uv(1), 1));
    return found;
}

Handle(Geom_BSplineSurface) FaceSpline::surface() const
{
    TColgp_Array2OfPnt points(1, u_.count(), 1, v_.count());
    for (int i = 0; i < u_.count(); ++i)
        for (int j = 0; j < v_.count(); ++j)
        {
            const auto row = poles_.row(i * v_.count() + j);
            points.SetValue(i + 1, j + 1, gp_Pnt(row(0), row(1), row(2)));
        }
    const auto knots = [](const CubicBasis& basis)
    {
        TColStd_Array1OfReal found(1, basis.span_count() + 1);
        for (int i = 1; i <= found.Length(); ++i)
            found.SetValue(i, basis.ends()[static_cast<std::size_t>(i - 1)]);
        return found;
    };
    const auto times = [](const CubicBasis& basis)
    {
        TColStd_Array1OfInteger found(1, basis.span_count() + 1);
        for (int i = 1; i <= found.Length(); ++i)
            found.SetValue(
                i, static_cast<int>(std::count(basis.knots().begin(), basis.knots().end(),
                                               basis.ends()[static_cast<std::size_t>(i - 1)])));
        return found;
    };
    return new Geom_BSplineSurface(points, knots(u_), knots(v_), times(u_), times(v_), 3, 3);
}

}  // namespace sheetmorph::cad

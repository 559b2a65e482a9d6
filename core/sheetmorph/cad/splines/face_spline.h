// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/meshing/face_mesh.h"
#include "sheetmorph/cad/splines/cubic_basis.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_Surface.hxx>
#include <functional>

namespace sheetmorph::cad
{

class PlateSystem;

//! A place that a carried surface must meet.
struct SurfacePlace
{
    Vector2 uv = Vector2::Zero();
    Vector3 target = Vector3::Zero();  //!< mm
    double weight = 1.0;
    double tolerance = 0.0;  //!< mm
    double spacing = 0.0;    //!< distance to the next place, mm; spans are not much shorter
};

//! A curve that a carried surface must meet.
struct SurfaceTrack
{
    std::function<Vector2(double)> uv;
    std::function<Vector3(double)> target;  //!< mm
    //! Its unit normal; 0 at places without one; empty if there is none at all.
    std::function<Vector3(double)> normal;
    std::vector<double> parameters;  //!< ascending, with both ends; dense enough for its shape
    double tolerance = 0.0;          //!< mm
    bool is_point = false;           //!< the curve is a point in space
};

//! A place where a carried surface has a prescribed unit normal.
struct SurfaceNormal
{
    Vector2 uv = Vector2::Zero();
    Vector3 normal = Vector3::Zero();
    double weight = 1.0;
    double spacing = 0.0;
};

//! All conditions on a carried surface.
struct SplineTargets
{
    std::vector<SurfacePlace> places;
    std::vector<SurfaceTrack> tracks;
};

//! A knot of a curve along which only one parameter of a surface changes.
struct CurveKnot
{
    double at = 0.0;
    double spacing = 0.0;  //!< distance to the nearer of its neighbours
};

//! The part of a surface on which a face lies.
struct SurfacePatch
{
    Handle(Geom_Surface) surface;
    Vector2 low = Vector2::Zero(), high = Vector2::Zero();
    //! Which of the four borders are one point: u low, u high, v low, v high.
    std::array<bool, 4> is_pole = {};
    //! Whether both borders in u, or in v, are one curve, on which the face has a seam.
    std::array<bool, 2> is_closed = {};
    //! Knots of curves to meet, by the parameter that changes along them. With the same knots, the
    //! surface can meet them exactly.
    std::array<std::vector<CurveKnot>, 2> knots;
};

//! A cubic spline surface: the sum of a surface and its displacement, over the same parameters.
class FaceSpline
{
public:
    //! The surface without a displacement.
    explicit FaceSpline(const SurfacePatch& patch);

    //! Fits places and curves to their tolerances by least squares. The energy of a thin plate
    //! determines the rest. Halves spans where the fit fails.
    //! \param tolerance  for the interpolation of the surface itself, mm
    //! \throws Cancelled
    void fit(const SplineTargets& targets, double tolerance, const Progress& progress);

    //! Rounds all coordinates to multiples of a length, which shortens files.
    void round_to(double grain);

    Vector3 point(const Vector2& uv) const;
    Eigen::Matrix<double, 3, 2> tangents(const Vector2& uv) const;

    Handle(Geom_BSplineSurface) surface() const;

private:
    void solve(const std::vector<SurfacePlace>& places, const std::vector<SurfaceNormal>& normals,
               const FaceSpline& before);
    void tie_seams(PlateSystem& system) const;
    void close();
    void add_places(const SurfaceTrack& track, std::vector<SurfacePlace>& places) const;
    void add_normals(const SurfaceTrack& track, std::vector<SurfaceNormal>& normals) const;
    double spans_between(const Vector2& here, const Vector2& there) const;
    void interpolate();
    Vector3 sum(const CubicBasis::Row& u, const CubicBasis::Row& v) const;

    friend class SpanChoice;

    SurfacePatch patch_;
    CubicBasis u_, v_;
    Vector2 scale_;                 // mm per parameter
    Eigen::MatrixXd base_, poles_;  // (u count * v count, 3), v fastest: surface; sum
};

}  // namespace sheetmorph::cad

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

//! A place that a carried surface goes through.
struct SurfacePlace
{
    Vector2 uv = Vector2::Zero();
    Vector3 target = Vector3::Zero();  //!< mm
    double weight = 1.0;
    double tolerance = 0.0;  //!< mm
    double spacing = 0.0;    //!< to the next place, mm; spans are not much shorter
};

//! A curve that a carried surface goes through.
struct SurfaceTrack
{
    std::function<Vector2(double)> uv;
    std::function<Vector3(double)> target;  //!< mm
    //! Its normal there, of length 1, or 0 where none is wanted; empty if none is anywhere.
    std::function<Vector3(double)> normal;
    std::vector<double> parameters;  //!< ascending; both ends, and enough to know its form
    double tolerance = 0.0;          //!< mm
    bool is_point = false;           //!< in space
};

//! A place where a carried surface has a given normal, of length 1.
struct SurfaceNormal
{
    Vector2 uv = Vector2::Zero();
    Vector3 normal = Vector3::Zero();
    double weight = 1.0;
    double spacing = 0.0;
};

//! All that a carried surface is made of.
struct SplineTargets
{
    std::vector<SurfacePlace> places;
    std::vector<SurfaceTrack> tracks;
};

//! A knot of a curve along which one parameter of a surface changes alone.
struct CurveKnot
{
    double at = 0.0;
    double spacing = 0.0;  //!< to the nearer of its neighbours
};

//! The part of a surface that a face lies on.
struct SurfacePatch
{
    Handle(Geom_Surface) surface;
    Vector2 low = Vector2::Zero(), high = Vector2::Zero();
    //! Which of the four borders are one point: u low, u high, v low, v high.
    std::array<bool, 4> is_pole = {};
    //! Whether both borders in u, in v, are one curve, with a seam of the face on it.
    std::array<bool, 2> is_closed = {};
    //! Of curves that it shall meet, by the parameter that changes along them: with the same knots
    //! it can meet them exactly.
    std::array<std::vector<CurveKnot>, 2> knots;
};

//! A cubic spline surface: a surface and a displacement of it, over the same parameters.
class FaceSpline
{
public:
    //! The surface alone.
    explicit FaceSpline(const SurfacePatch& patch);

    //! Brings it as near to places and curves as their tolerances say, by least squares with a thin
    //! plate's energy where nothing is known, and cuts spans where that fails.
    //! \param tolerance  of what is interpolated of the surface itself, mm
    //! \throws Cancelled
    void fit(const SplineTargets& targets, double tolerance, const Progress& progress);

    //! Makes all coordinates multiples of a length: they are shorter in a file.
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
    Eigen::MatrixXd base_, poles_;  // (u count * v count, 3), v fastest: of the surface, of both
};

}  // namespace sheetmorph::cad

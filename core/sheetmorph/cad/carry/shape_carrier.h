// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/carry/carried_shape.h"
#include "sheetmorph/cad/carry/kept_motion.h"
#include "sheetmorph/cad/splines/arc_length.h"
#include "sheetmorph/cad/splines/face_spline.h"
#include "sheetmorph/cad/splines/spline_curve.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <optional>

namespace sheetmorph::cad
{

//! A face at rest and carried.
struct CarriedFace
{
    TopoDS_Face face;
    Handle(Geom_Surface) rest, surface;
    std::optional<KeptMotion> motion;  //!< if the face keeps its surface
    std::optional<FaceSpline> spline;  //!< if the face is fitted
    SplineTargets targets;             //!< for the spline
    double tolerance = 0.0;
};

//! An edge on one of its faces.
struct EdgeOnFace
{
    int face = -1;
    Handle(Geom2d_Curve) curve;    //!< in the parameters of the face
    Handle(Geom2d_Curve) written;  //!< as a spline, on a fitted face
};

//! An edge at rest and carried.
struct CarriedEdge
{
    TopoDS_Edge edge;
    bool is_degenerated = false;
    double low = 0.0, high = 0.0;
    int first = -1, last = -1;  //!< vertices
    std::vector<EdgeOnFace> uses;
    Handle(Geom_Curve) rest, curve;
    std::optional<KeptMotion> motion;
    //! For an edge without a motion: the displacement of its points, by arc length.
    std::optional<SplineCurve> shift;
    std::optional<ArcLength> length;
    //! Additional derivative of the shift at both ends.
    std::array<Vector3, 2> bend = {Vector3::Zero(), Vector3::Zero()};
    std::array<double, 2> reach = {};  //!< reach of the bends: to the next vertex of the mesh, mm
    std::vector<double> samples;       //!< parameters, ascending, ends included
    bool is_smooth = false;            //!< its two faces had a common tangent plane at rest
    double tolerance = 0.0;

    Vector3 at(double t) const;
};

struct CarriedVertex
{
    TopoDS_Vertex vertex;
    Vector3 point = Vector3::Zero();
    double tolerance = 0.0;
};

//! The faces, edges and vertices of a shape while they are carried, in the order of its ShapeMesh.
class ShapeCarrier
{
public:
    //! \throws InvalidInput if a face has no mesh
    ShapeCarrier(const ShapeMesh& mesh, const Points& result, const CarryTolerances& tolerances);

    void run(const Progress& progress);

    const ShapeMesh& mesh() const { return mesh_; }
    const std::vector<CarriedFace>& faces() const { return faces_; }
    const std::vector<CarriedEdge>& edges() const { return edges_; }
    const std::vector<CarriedVertex>& vertices() const { return vertices_; }
    const WorstAt& gap() const { return gap_; }

private:
    void find_faces();
    void find_uses();
    void find_edges();
    void find_edge(int index);
    void find_vertices();
    void find_shift(CarriedEdge& edge, const VerticesOnEdge& known) const;
    void carry_edge(CarriedEdge& edge);
    void join_slopes();
    void join_slopes(CarriedEdge& one, bool is_low, CarriedEdge& other, bool is_other_low) const;
    SplineCurve displacement(const CarriedEdge& edge, const VerticesOnEdge& known) const;
    SurfacePatch patch_of(int face) const;
    void collect_tracks(int face);
    void collect_inner_places(int face);
    void fit_faces(bool is_again, const Progress& progress);
    Vector3 shared_normal(const CarriedEdge& edge, double t) const;
    Vector3 normal(const EdgeOnFace& use, double t) const;
    bool is_smooth_at(const CarriedEdge& edge, double t) const;
    Vector3 point(const EdgeOnFace& use, double t) const;
    void lay_on_faces(CarriedEdge& edge);
    void measure();
    void measure_edge(CarriedEdge& edge);
    double distance_at_rest(const CarriedEdge& edge, const EdgeOnFace& use, double t) const;
    void measure_end(const CarriedEdge& edge, bool is_low);

    const ShapeMesh& mesh_;
    const Points& result_;
    CarryTolerances tolerances_;
    double rigid_tolerance_;
    std::vector<CarriedFace> faces_;
    std::vector<std::optional<FaceSpline>> before_;  // their splines before a pass; empty at first
    std::vector<CarriedEdge> edges_;
    std::vector<CarriedVertex> vertices_;
    WorstAt gap_;
};

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/writing/body_measurer.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/meshing/occt_surface.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace sheetmorph::cad
{

namespace
{

constexpr double degrees = 1.0 / degree;  // from geometry
constexpr double smooth = 0.8;            // degrees; from ShapeCarrier::is_smooth_at()

// The outward normal of a face at a parameter of an edge; nothing at a pole.
std::optional<Vector3> normal_at(const TopoDS_Edge& edge, const TopoDS_Face& face, double share)
{
    double low = 0.0, high = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, low, high);
    if (curve.IsNull())
        return {};
    const gp_Pnt2d uv = curve->Value(low + share * (high - low));
    const Eigen::Matrix<double, 3, 2> tangents = OcctSurface(face).tangents({uv.X(), uv.Y()});
    const Vector3 normal = tangents.col(0).cross(tangents.col(1));
    if (!(normal.norm() > 1e-6 * tangents.col(0).norm() * tangents.col(1).norm()))
        return {};
    return normal.normalized() * (face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0);
}

// The largest angle between two faces along an edge, degrees; 180 if unknown.
WorstAt kink_at(const TopoDS_Edge& edge, const TopoDS_Face& one, const TopoDS_Face& other)
{
    WorstAt worst;
    for (const double share : {0.03, 0.15, 0.27, 0.39, 0.5, 0.61, 0.73, 0.85, 0.97})
    {
        const auto a = normal_at(edge, one, share), b = normal_at(edge, other, share);
        if (!a || !b)
            continue;
        const double angle = degrees * std::atan2(a->cross(*b).norm(), a->dot(*b));
        if (angle < worst.value && worst.face >= 0)
            continue;
        double low = 0.0, high = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, low, high);
        worst = {angle, 0, to_vector(curve->Value(low + share * (high - low)).XYZ())};
    }
    return worst;
}

using Pair = std::pair<int, int>;

// The largest angle along the edges between two faces, by the pair of faces, counted from 0.
std::map<Pair, WorstAt> kinks_of(const TopoDS_Shape& body, const TopTools_IndexedMapOfShape& faces)
{
    std::map<Pair, WorstAt> found;
    TopTools_IndexedDataMapOfShapeListOfShape edges;
    TopExp::MapShapesAndAncestors(body, TopAbs_EDGE, TopAbs_FACE, edges);
    for (int i = 1; i <= edges.Extent(); ++i)
    {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(i));
        const TopTools_ListOfShape& beside = edges(i);
        if (beside.Extent() != 2 || BRep_Tool::Degenerated(edge))
            continue;
        const TopoDS_Face& one = TopoDS::Face(beside.First());
        const TopoDS_Face& other = TopoDS::Face(beside.Last());
        Pair pair(faces.FindIndex(one) - 1, faces.FindIndex(other) - 1);
        if (pair.first == pair.second)
            continue;
        if (pair.first > pair.second)
            std::swap(pair.first, pair.second);
        WorstAt here = kink_at(edge, one, other);
        here.face = here.face < 0 ? -1 : pair.first;
        if (const auto known = found.find(pair);
            known == found.end() || known->second.value < here.value)
            found[pair] = here;
    }
    return found;
}

double largest_tolerance(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, kind, parts);
    double worst = 0.0;
    for (int i = 1; i <= parts.Extent(); ++i)
        worst =
            std::max(worst, kind == TopAbs_EDGE ? BRep_Tool::Tolerance(TopoDS::Edge(parts(i)))
                                                : BRep_Tool::Tolerance(TopoDS::Vertex(parts(i))));
    return worst;
}

// Volume inside a closed mesh, mm^3.
double volume_of(const Points& points, const Triangles& triangles)
{
    const Vector3 middle = points.colwise().mean().transpose();
    const auto corner = [&](Eigen::Index t, int k)
    { return Vector3(points.row(triangles(t, k)).transpose() - middle); };
    double sum = 0.0;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        sum += corner(t, 0).dot(corner(t, 1).cross(corner(t, 2)));
    return std::abs(sum) / 6.0;
}

bool is_closed(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape shells;
    TopExp::MapShapes(shape, TopAbs_SHELL, shells);
    bool found = !shells.IsEmpty();
    for (int i = 1; i <= shells.Extent(); ++i)
        found = found && BRep_Tool::IsClosed(shells(i));
    return found;
}

}  // namespace

BodyMeasurer::BodyMeasurer(const ShapeMesh& mesh, const CarriedShape& carried,
                           const NamedShape& body)
    : before_(mesh),
      mesh_(*carried.mesh),
      carried_(carried),
      body_(body.shape),
      is_valid_(body.faults.empty() && body.healed.empty())
{
    TopExp::MapShapes(carried.shape, TopAbs_FACE, made_);
    TopExp::MapShapes(body_, TopAbs_FACE, read_);
    if (made_.Extent() != read_.Extent())
        throw SolverError("a part has " + std::to_string(read_.Extent()) + " faces instead of "
                          + std::to_string(made_.Extent()) + " in the written file");
}

const TopoDS_Shape& BodyMeasurer::image_of(int face) const
{
    const int own = face - before_.faces.Extent();
    return own < 0 ? carried_.image.Find(before_.faces(face + 1))
                   : carried_.washers[static_cast<std::size_t>(own)].second;
}

TopoDS_Shape BodyMeasurer::read_face(int face) const
{
    return read_(made_.FindIndex(image_of(face)));
}

CadMeasures BodyMeasurer::measures(const Points& result, double tolerance) const
{
    CadMeasures found;
    found.faces = mesh_.faces.Extent();
    found.washers = static_cast<int>(carried_.washers.size());
    for (std::size_t f = 0; f < carried_.is_kept.size(); ++f)
        if (carried_.is_kept[f])
            ++found.kept;
        else
            found.fitted_faces.push_back(static_cast<int>(f));
    found.points = measure_distances(found, result, tolerance);
    measure_kinks(found);
    measure_cylinders(found);
    check_shape(found);
    if (found.was_closed)
    {
        found.volume_before = volume_of(mesh_.rest, mesh_.triangles);
        found.volume_after = volume_of(found.points, mesh_.triangles);
    }
    return found;
}

// The vertices of the mesh, projected to the faces that were read.
Points BodyMeasurer::measure_distances(CadMeasures& found, const Points& result,
                                       double tolerance) const
{
    Points read = result;
    for (int f = 0; f < found.faces; ++f)
    {
        const TopoDS_Face face = TopoDS::Face(read_face(f));
        const OcctSurface surface(face);
        const VerticesOnFace& known = mesh_.on_face[static_cast<std::size_t>(f)];
        ShapeAnalysis_Surface projection(BRep_Tool::Surface(face));
        double worst = 0.0;
        for (std::size_t i = 0; i < known.vertices.size(); ++i)
        {
            const Vector3 wanted = result.row(known.vertices[i]).transpose();
            Vector3 there = surface.point(known.parameters[i]);
            double distance = (there - wanted).norm();
            if (distance > 0.5 * tolerance)  // perhaps written with other parameters
            {
                const gp_Pnt2d uv =
                    projection.ValueOfUV(gp_Pnt(wanted(0), wanted(1), wanted(2)), 1e-7);
                if (projection.Gap() < distance)
                {
                    distance = projection.Gap();
                    there = to_vector(projection.Value(uv).XYZ());
                }
            }
            read.row(known.vertices[i]) = there.transpose();
            worst = std::max(worst, distance);
            if (distance > found.distance.value)
                found.distance = {distance, f, wanted};
        }
        if (!(worst <= tolerance))
            found.far_faces.push_back(f);
    }
    return read;
}

void BodyMeasurer::measure_kinks(CadMeasures& found) const
{
    const auto after = kinks_of(body_, read_);
    for (const auto& [pair, before] : kinks_of(mesh_.shape, mesh_.faces))
    {
        const auto [one, other] = pair;
        if (before.face < 0 || before.value > smooth
            || (carried_.is_kept[static_cast<std::size_t>(one)]
                && carried_.is_kept[static_cast<std::size_t>(other)]))
            continue;
        Pair there(read_.FindIndex(read_face(one)) - 1, read_.FindIndex(read_face(other)) - 1);
        if (there.first > there.second)
            std::swap(there.first, there.second);
        const auto here = after.find(there);
        if (here != after.end() && here->second.value > found.kink.value)
            found.kink = {here->second.value, one, here->second.place};
    }
}

void BodyMeasurer::measure_cylinders(CadMeasures& found) const
{
    constexpr double exact = 1e-5;  // mm; from part_mesher.cpp, as the reader recognises them
    for (int f = 0; f < found.faces; ++f)
    {
        // IGES and other systems draw cylinders as splines and surfaces of revolution.
        const CadSurface before = describe_surface(TopoDS::Face(mesh_.faces(f + 1)), exact);
        if (before.kind != SurfaceKind::cylinder || !carried_.is_kept[static_cast<std::size_t>(f)])
            continue;
        const CadSurface after = describe_surface(TopoDS::Face(read_face(f)), exact);
        const double radius = after.kind == SurfaceKind::cylinder ? after.radius : 0.0;
        found.cylinders.push_back({f, before.radius,
                                   carried_.scale[static_cast<std::size_t>(f)] * before.radius,
                                   radius});
    }
}

void BodyMeasurer::check_shape(CadMeasures& found) const
{
    found.is_valid = is_valid_;
    found.gap = carried_.gap;
    for (int f = 0; f < found.faces && !is_valid_; ++f)
        if (!BRepCheck_Analyzer(read_face(f)).IsValid())
            found.invalid_faces.push_back(f);
    found.is_closed = is_closed(body_);
    found.was_closed = is_closed(before_.shape);
    found.edge_tolerance = largest_tolerance(carried_.shape, TopAbs_EDGE);
    found.edge_tolerance_read = largest_tolerance(body_, TopAbs_EDGE);
    found.vertex_tolerance = largest_tolerance(body_, TopAbs_VERTEX);
}

}  // namespace sheetmorph::cad

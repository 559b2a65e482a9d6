// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/shape_carrier.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/cad/carry/face_motions.h"
#include "sheetmorph/cad/carry/face_patch.h"
#include "sheetmorph/cad/meshing/occt_surface.h"
#include "sheetmorph/cad/splines/parameter_curve.h"
#include "sheetmorph/cad/splines/surface_breaks.h"

#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GeomAdaptor_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

Vector3 point_of(const gp_Pnt& point)
{
    return to_vector(point.XYZ());
}

// The curve of an edge, placed like the edge; null if the edge has no extent.
Handle(Geom_Curve) placed_curve(const TopoDS_Edge& edge)
{
    TopLoc_Location place;
    double low = 0.0, high = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, place, low, high);
    return curve.IsNull()
               ? curve
               : Handle(Geom_Curve)::DownCast(curve->Transformed(place.Transformation()));
}

// The parameters of the mesh, with further ones where it has few.
std::vector<double> samples_between(const std::vector<double>& parameters)
{
    const int pieces = static_cast<int>(parameters.size()) - 1;
    const int cuts = std::max(1, 4 / std::max(pieces, 1));
    std::vector<double> found;
    for (std::size_t i = 0; i + 1 < parameters.size(); ++i)
        for (int cut = 0; cut < cuts; ++cut)
            found.push_back(parameters[i] + cut * (parameters[i + 1] - parameters[i]) / cuts);
    found.push_back(parameters.back());
    return found;
}

// Part of an edge's shift: cubics with a slope at the ends that vanish at `reach`.
Vector3 bent_by(const CarriedEdge& edge, double place)
{
    Vector3 sum = Vector3::Zero();
    const double whole = edge.length->whole();
    for (std::size_t k = 0; k < 2; ++k)
    {
        const double away = k == 0 ? place : whole - place;
        const double left = 1.0 - away / edge.reach[k];
        if (left > 0.0)
            sum += (k == 0 ? away : -away) * left * left * edge.bend[k];
    }
    return sum;
}

// One end of an edge, and the change of its shift there per mm along the edge.
struct EdgeEnd
{
    EdgeEnd(const CarriedEdge& edge, bool is_at_low) : is_low(is_at_low)
    {
        const double t = is_low ? edge.low : edge.high;
        gp_Pnt here;
        gp_Vec along;
        edge.rest->D1(t, here, along);
        inward = is_low ? 1.0 : -1.0;
        direction = inward / std::max(along.Magnitude(), 1e-12) * to_vector(along.XYZ());
        if (edge.shift)
            slope = inward * edge.shift->derivative(is_low ? 0.0 : edge.length->whole());
        else
        {
            constexpr double step = 1e-3;  // mm; chosen: rounding leaves 1e-10
            const Vector3 place = point_of(here);
            slope =
                (edge.motion->point(place + step * direction) - edge.motion->point(place)) / step
                - direction;
        }
    }

    void bend(CarriedEdge& edge, const Vector3& wanted) const
    {
        if (edge.shift)
            edge.bend[is_low ? 0 : 1] = inward * (wanted - slope);
    }

    bool is_low;
    double inward;  // sign of a step along the edge that leads into it
    Vector3 direction, slope;
};

// The outward unit normal of a face with these tangents; 0 at a pole.
Vector3 normal_across(const Eigen::Matrix<double, 3, 2>& tangents, const TopoDS_Face& face)
{
    const Vector3 across = tangents.col(0).cross(tangents.col(1));
    const double length = across.norm();
    if (!(length > 1e-6 * tangents.col(0).norm() * tangents.col(1).norm()) || !(length > 0.0))
        return Vector3::Zero();
    return (face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0) / length * across;
}

Eigen::Matrix<double, 3, 2> tangents_of(const Handle(Geom_Surface) & surface, const gp_Pnt2d& uv)
{
    gp_Pnt here;
    gp_Vec u, v;
    surface->D1(uv.X(), uv.Y(), here, u, v);
    Eigen::Matrix<double, 3, 2> found;
    found << to_vector(u.XYZ()), to_vector(v.XYZ());
    return found;
}

bool is_beside_smooth(const CarriedFace& face)
{
    const std::vector<SurfaceTrack>& tracks = face.targets.tracks;
    return std::any_of(tracks.begin(), tracks.end(),
                       [](const SurfaceTrack& track) { return static_cast<bool>(track.normal); });
}

VertexIds distinct(VertexIds vertices)
{
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

}  // namespace

Vector3 CarriedEdge::at(double t) const
{
    return point_of(curve->Value(t));
}

ShapeCarrier::ShapeCarrier(const ShapeMesh& mesh, const Points& result,
                           const CarryTolerances& tolerances)
    : mesh_(mesh), result_(result), tolerances_(tolerances), rigid_tolerance_(rigid_tolerance(mesh))
{
    find_faces();
    find_uses();
    find_vertices();
    find_edges();
}

void ShapeCarrier::find_faces()
{
    FaceMotions motions = face_motions(mesh_, result_, rigid_tolerance_);
    for (int f = 0; f < mesh_.faces.Extent(); ++f)
    {
        CarriedFace found;
        found.face = TopoDS::Face(mesh_.faces(f + 1));
        found.rest = placed_surface(found.face);
        found.motion = std::move(motions[static_cast<std::size_t>(f)]);
        if (found.motion)
            found.surface = found.motion->surface(found.rest);
        faces_.push_back(std::move(found));
    }
}

void ShapeCarrier::find_uses()
{
    constexpr double of_edge = 0.1;  // chosen: curves beneath an edge use a tenth of its tolerance
    edges_.resize(static_cast<std::size_t>(mesh_.edges.Extent()));
    for (std::size_t f = 0; f < faces_.size(); ++f)
    {
        const TopoDS_Shape face = faces_[f].face.Oriented(TopAbs_FORWARD);
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            double low = 0.0, high = 0.0;
            EdgeOnFace use;
            use.face = static_cast<int>(f);
            use.curve = BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face), low, high);
            if (!use.curve.IsNull() && !faces_[f].motion)
            {
                const Handle(Geom_Curve) curve = placed_curve(edge);
                if (!curve.IsNull() && !BRep_Tool::IsClosed(edge, TopoDS::Face(face)))
                    use.curve = curve_beneath(curve, faces_[f].rest, use.curve, low, high,
                                              of_edge * tolerances_.edge);
                use.written = spline_in_parameters(use.curve, low, high);
            }
            CarriedEdge& found = edges_[static_cast<std::size_t>(mesh_.edges.FindIndex(edge) - 1)];
            if (found.uses.empty())
            {
                found.low = low;
                found.high = high;
            }
            if (!use.curve.IsNull())
                found.uses.push_back(use);
        }
    }
}

void ShapeCarrier::find_vertices()
{
    std::vector<const KeptMotion*> motions(static_cast<std::size_t>(mesh_.vertices.Extent()));
    for (const CarriedFace& face : faces_)
        if (face.motion)
            for (TopExp_Explorer it(face.face, TopAbs_VERTEX); it.More(); it.Next())
                motions[static_cast<std::size_t>(mesh_.vertices.FindIndex(it.Current()) - 1)] =
                    &*face.motion;
    for (int v = 0; v < mesh_.vertices.Extent(); ++v)
    {
        CarriedVertex found;
        found.vertex = TopoDS::Vertex(mesh_.vertices(v + 1));
        found.point = point_of(BRep_Tool::Pnt(found.vertex));
        const auto i = static_cast<std::size_t>(v);
        int near = mesh_.on_vertex[i];
        if (near < 0)
            (mesh_.rest.rowwise() - found.point.transpose())
                .rowwise()
                .squaredNorm()
                .minCoeff(&near);
        if (motions[i])
            found.point = motions[i]->point(found.point);
        else
            found.point += (result_.row(near) - mesh_.rest.row(near)).transpose();
        vertices_.push_back(found);
    }
}

void ShapeCarrier::find_edges()
{
    for (int e = 0; e < mesh_.edges.Extent(); ++e)
        find_edge(e);
    join_slopes();
    for (CarriedEdge& edge : edges_)
        if (!edge.is_degenerated)
            carry_edge(edge);
}

void ShapeCarrier::find_edge(int index)
{
    CarriedEdge& found = edges_[static_cast<std::size_t>(index)];
    const VerticesOnEdge& known = mesh_.on_edge[static_cast<std::size_t>(index)];
    found.edge = TopoDS::Edge(mesh_.edges(index + 1));
    TopoDS_Vertex first, last;
    TopExp::Vertices(found.edge, first, last);
    found.first = first.IsNull() ? -1 : mesh_.vertices.FindIndex(first) - 1;
    found.last = last.IsNull() ? -1 : mesh_.vertices.FindIndex(last) - 1;
    found.is_degenerated = BRep_Tool::Degenerated(found.edge);
    found.samples =
        samples_between(known.parameters.size() > 1 ? known.parameters
                                                    : std::vector<double>{found.low, found.high});
    if (found.is_degenerated)
        return;
    found.rest = placed_curve(found.edge);
    if (found.rest.IsNull() || found.first < 0 || found.last < 0)
        throw InvalidInput("edge " + std::to_string(index) + " has no curve",
                           "repair it in the CAD system");
    BRep_Tool::Range(found.edge, found.low, found.high);
    if (known.parameters.empty())
        found.samples = samples_between({found.low, found.high});
    for (const EdgeOnFace& use : found.uses)
        if (faces_[static_cast<std::size_t>(use.face)].motion)
            found.motion = faces_[static_cast<std::size_t>(use.face)].motion;
    if (!found.motion)
    {
        const VertexIds vertices = distinct(known.vertices);
        found.motion =
            rigid_fit(rows_of(vertices, mesh_.rest), rows_of(vertices, result_), rigid_tolerance_,
                      GeomAdaptor_Curve(found.rest).GetType() == GeomAbs_Line);
    }
    if (!found.motion)
        find_shift(found, known);
}

void ShapeCarrier::find_shift(CarriedEdge& edge, const VerticesOnEdge& known) const
{
    edge.length.emplace(edge.rest, edge.low, edge.high);
    edge.shift = displacement(edge, known);
    const double whole = edge.length->whole();
    const std::size_t count = known.parameters.size();
    edge.reach.fill(whole);
    if (count > 2)
        edge.reach = {edge.length->at(known.parameters[1]),
                      whole - edge.length->at(known.parameters[count - 2])};
}

// Edges that continue each other smoothly stay smooth. Otherwise no surface next to both could
// follow them.
void ShapeCarrier::join_slopes()
{
    std::vector<std::vector<std::pair<CarriedEdge*, bool>>> ends(vertices_.size());
    for (CarriedEdge& edge : edges_)
        if (!edge.is_degenerated)
            for (const bool is_low : {true, false})
                ends[static_cast<std::size_t>(is_low ? edge.first : edge.last)].push_back(
                    {&edge, is_low});
    for (const auto& here : ends)
        for (std::size_t i = 0; i < here.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (here[i].first->shift || here[k].first->shift)
                    join_slopes(*here[i].first, here[i].second, *here[k].first, here[k].second);
}

void ShapeCarrier::join_slopes(CarriedEdge& one, bool is_low, CarriedEdge& other,
                               bool is_other_low) const
{
    constexpr double straight = 0.999;  // chosen: edges that bend by less than 2.6 degrees go on
    const EdgeEnd a(one, is_low), b(other, is_other_low);
    const double along = a.direction.dot(b.direction);
    if (!(std::abs(along) > straight))
        return;
    const double sign = along < 0.0 ? -1.0 : 1.0;
    const Vector3 slope = !one.shift     ? a.slope
                          : !other.shift ? Vector3(sign * b.slope)
                                         : Vector3(0.5 * (a.slope + sign * b.slope));
    a.bend(one, slope);
    b.bend(other, sign * slope);
}

void ShapeCarrier::carry_edge(CarriedEdge& edge)
{
    if (edge.motion)
        edge.curve = edge.motion->curve(edge.rest);
    if (!edge.curve.IsNull())
        return;
    PointAt target;
    if (edge.motion)
        target = [&](double t) { return edge.motion->point(point_of(edge.rest->Value(t))); };
    else
        target = [&edge](double t) -> Vector3
        {
            const double place = edge.length->at(t);
            return point_of(edge.rest->Value(t)) + edge.shift->at(place) + bent_by(edge, place);
        };
    const CubicBasis start(edge.low, edge.high, curve_breaks(edge.rest, edge.low, edge.high));
    // Includes slopes of short edges, because faces that continue smoothly across follow them.
    const double whole = ArcLength(edge.rest, edge.low, edge.high).whole();
    SplineCurve spline = curve_near(target, start, std::min(0.5 * tolerances_.edge, 3e-6 * whole));
    spline.poles = tolerances_.grain * (spline.poles / tolerances_.grain).array().round();
    edge.curve = spline.curve();
}

SplineCurve ShapeCarrier::displacement(const CarriedEdge& edge, const VerticesOnEdge& known) const
{
    std::vector<double> places;
    std::vector<Vector3> shifts;
    const double whole = edge.length->whole(), least = 1e-9 * whole;
    const auto add = [&](double place, const Vector3& shift)
    {
        if (!places.empty() && place < places.back() + least)
            return;
        places.push_back(place);
        shifts.push_back(shift);
    };
    // An edge that ends next to its vertex in the file does so again, because its faces are there.
    const auto shift_of = [&](int vertex) -> Vector3
    {
        const CarriedVertex& end = vertices_[static_cast<std::size_t>(vertex)];
        return end.point - point_of(BRep_Tool::Pnt(end.vertex));
    };
    add(0.0, shift_of(edge.first));
    for (std::size_t i = 1; i + 1 < known.parameters.size(); ++i)
        if (const double place = edge.length->at(known.parameters[i]); place < whole - least)
            add(place,
                (result_.row(known.vertices[i]) - mesh_.rest.row(known.vertices[i])).transpose());
    add(whole, shift_of(edge.last));
    Points rows(static_cast<Eigen::Index>(shifts.size()), 3);
    for (std::size_t i = 0; i < shifts.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = shifts[i].transpose();
    gp_Pnt here;
    gp_Vec at_low, at_high;
    edge.rest->D1(edge.low, here, at_low);
    edge.rest->D1(edge.high, here, at_high);
    const bool is_closed = edge.first == edge.last && at_low.Angle(at_high) < 1e-3;
    return curve_through(places, rows, is_closed);
}

Vector3 ShapeCarrier::point(const EdgeOnFace& use, double t) const
{
    const CarriedFace& face = faces_[static_cast<std::size_t>(use.face)];
    const gp_Pnt2d uv = (face.spline ? use.written : use.curve)->Value(t);
    if (face.spline)
        return face.spline->point({uv.X(), uv.Y()});
    return point_of(face.surface->Value(uv.X(), uv.Y()));
}

// Uses the splines from before the current pass, because faces are fitted in parallel.
Vector3 ShapeCarrier::normal(const EdgeOnFace& use, double t) const
{
    const CarriedFace& face = faces_[static_cast<std::size_t>(use.face)];
    const std::optional<FaceSpline>& spline = before_[static_cast<std::size_t>(use.face)];
    const gp_Pnt2d uv = use.curve->Value(t);
    return normal_across(
        spline ? spline->tangents({uv.X(), uv.Y()}) : tangents_of(face.surface, uv), face.face);
}

bool ShapeCarrier::is_smooth_at(const CarriedEdge& edge, double t) const
{
    constexpr double smooth = 0.9999;  // 0.8 degrees; chosen: no designer means so small a kink
    std::array<Vector3, 2> normals;
    for (std::size_t k = 0; k < 2; ++k)
    {
        const CarriedFace& face = faces_[static_cast<std::size_t>(edge.uses[k].face)];
        normals[k] = normal_across(tangents_of(face.rest, edge.uses[k].curve->Value(t)), face.face);
    }
    return normals[0].dot(normals[1]) > smooth;
}

SurfacePatch ShapeCarrier::patch_of(int face) const
{
    std::vector<FaceBorder> borders;
    for (const CarriedEdge& edge : edges_)
        for (const EdgeOnFace& use : edge.uses)
            if (use.face == face)
                borders.push_back({use.curve, edge.low, edge.high, edge.is_degenerated,
                                   edge.motion ? Handle(Geom_Curve)() : edge.curve});
    return surface_patch(faces_[static_cast<std::size_t>(face)].rest, borders);
}

void ShapeCarrier::collect_tracks(int face)
{
    for (const CarriedEdge& edge : edges_)
        for (const EdgeOnFace& use : edge.uses)
        {
            if (use.face != face)
                continue;
            SurfaceTrack track;
            track.uv = [curve = use.curve](double t)
            {
                const gp_Pnt2d uv = curve->Value(t);
                return Vector2(uv.X(), uv.Y());
            };
            if (edge.is_degenerated)
                track.target = [there = vertices_[static_cast<std::size_t>(edge.first)].point](
                                   double) { return there; };
            else
                track.target = [&edge](double t) { return edge.at(t); };
            if (edge.is_smooth)
                track.normal = [this, &edge](double t) { return shared_normal(edge, t); };
            track.parameters = edge.samples;
            track.tolerance = 0.5 * tolerances_.edge;
            track.is_point = edge.is_degenerated;
            faces_[static_cast<std::size_t>(face)].targets.tracks.push_back(std::move(track));
        }
}

void ShapeCarrier::collect_inner_places(int face)
{
    CarriedFace& found = faces_[static_cast<std::size_t>(face)];
    std::vector<double> beside(static_cast<std::size_t>(result_.rows()), 0.0);
    for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t)
        if (mesh_.face_of_triangle[static_cast<std::size_t>(t)] == face)
            for (int k = 0; k < 3; ++k)
            {
                const int a = mesh_.triangles(t, k), b = mesh_.triangles(t, (k + 1) % 3);
                const double length = (mesh_.rest.row(a) - mesh_.rest.row(b)).norm();
                for (const int v : {a, b})
                    beside[static_cast<std::size_t>(v)] =
                        std::max(beside[static_cast<std::size_t>(v)], length);
            }
    for (TopExp_Explorer it(found.face, TopAbs_EDGE); it.More(); it.Next())
        for (const int v :
             mesh_.on_edge[static_cast<std::size_t>(mesh_.edges.FindIndex(it.Current()) - 1)]
                 .vertices)
            beside[static_cast<std::size_t>(v)] = 0.0;
    const VerticesOnFace& known = mesh_.on_face[static_cast<std::size_t>(face)];
    for (std::size_t i = 0; i < known.vertices.size(); ++i)
        if (const double length = beside[static_cast<std::size_t>(known.vertices[i])]; length > 0.0)
            found.targets.places.push_back({known.parameters[i],
                                            result_.row(known.vertices[i]).transpose(), 1.0,
                                            0.4 * tolerances_.surface, 0.4 * length});
}

void ShapeCarrier::run(const Progress& progress)
{
    // Measured with a prototype: two passes reduce kinks from 4.9 to 0.1 degrees.
    constexpr int passes = 2;
    for (CarriedEdge& edge : edges_)
        if (edge.uses.size() == 2 && edge.uses[0].face != edge.uses[1].face && !edge.is_degenerated)
        {
            edge.is_smooth = true;
            for (const double share : {0.1, 0.5, 0.9})
                edge.is_smooth =
                    edge.is_smooth && is_smooth_at(edge, edge.low + share * (edge.high - edge.low));
        }
    for (std::size_t f = 0; f < faces_.size(); ++f)
        if (!faces_[f].motion)
        {
            faces_[f].spline.emplace(patch_of(static_cast<int>(f)));
            collect_tracks(static_cast<int>(f));
            collect_inner_places(static_cast<int>(f));
        }
    fit_faces(false, progress.part(0.0, 0.4));
    for (int pass = 0; pass < passes; ++pass)
    {
        before_.clear();
        for (const CarriedFace& face : faces_)
            before_.push_back(face.spline);
        fit_faces(true, progress.part(0.4 + 0.3 * pass, 0.7 + 0.3 * pass));
    }
    for (CarriedFace& face : faces_)
        if (face.spline)
        {
            face.spline->round_to(tolerances_.grain);
            face.surface = face.spline->surface();
        }
    for (CarriedEdge& edge : edges_)
        lay_on_faces(edge);
    measure();
}

void ShapeCarrier::fit_faces(bool is_again, const Progress& progress)
{
    std::vector<Task> tasks;
    for (std::size_t f = 0; f < faces_.size(); ++f)
        if (faces_[f].spline && (!is_again || is_beside_smooth(faces_[f])))
            tasks.push_back({"fitting face " + std::to_string(f), [this, f](const Progress& own)
                             {
                                 CarriedFace& face = faces_[f];
                                 face.spline->fit(face.targets, 0.2 * tolerances_.surface, own);
                             }});
    run_tasks(tasks, progress);
}

// At a smooth edge, both faces take the mean normal, or that of the face that keeps its surface.
Vector3 ShapeCarrier::shared_normal(const CarriedEdge& edge, double t) const
{
    if (before_.empty())
        return Vector3::Zero();
    const Vector3 one = normal(edge.uses[0], t), other = normal(edge.uses[1], t);
    const auto is_kept = [&](std::size_t k)
    { return !before_[static_cast<std::size_t>(edge.uses[k].face)]; };
    if (one.norm() == 0.0 || other.norm() == 0.0)
        return Vector3::Zero();
    const Vector3 wanted = is_kept(0) ? one : is_kept(1) ? other : Vector3(one + other);
    return wanted.norm() > 0.5 ? Vector3(wanted.normalized()) : Vector3::Zero();
}

void ShapeCarrier::measure()
{
    for (CarriedEdge& edge : edges_)
    {
        measure_edge(edge);
        measure_end(edge, true);
        measure_end(edge, false);
    }
}

void ShapeCarrier::measure_edge(CarriedEdge& edge)
{
    constexpr int most = 300;  // samples, from measurements with a prototype on real parts
    constexpr double more = 1.02, least = 1e-7;  // chosen: between samples; mm, from OpenCASCADE
    edge.tolerance = edge.motion ? BRep_Tool::Tolerance(edge.edge) : least;
    for (const EdgeOnFace& use : edge.uses)
    {
        if (!faces_[static_cast<std::size_t>(use.face)].spline)
            continue;
        for (int i = 0; i <= most; ++i)
        {
            const double t = edge.low + i * (edge.high - edge.low) / most;
            const Vector3 here = edge.is_degenerated
                                     ? vertices_[static_cast<std::size_t>(edge.first)].point
                                     : edge.at(t);
            const double distance = (point(use, t) - here).norm();
            edge.tolerance = std::max(edge.tolerance, more * distance + 1e-8);
            if (distance > gap_.value && distance > distance_at_rest(edge, use, t))
                gap_ = {distance, use.face, here};
        }
    }
}

double ShapeCarrier::distance_at_rest(const CarriedEdge& edge, const EdgeOnFace& use,
                                      double t) const
{
    if (edge.is_degenerated)
        return 0.0;
    const gp_Pnt2d uv = use.curve->Value(t);
    const CarriedFace& face = faces_[static_cast<std::size_t>(use.face)];
    return face.rest->Value(uv.X(), uv.Y()).Distance(edge.rest->Value(t));
}

void ShapeCarrier::measure_end(const CarriedEdge& edge, bool is_low)
{
    const int index = is_low ? edge.first : edge.last;
    if (index < 0)
        return;
    CarriedVertex& vertex = vertices_[static_cast<std::size_t>(index)];
    double worst = edge.tolerance;
    const double t = is_low ? edge.low : edge.high;
    if (!edge.is_degenerated)
        worst = std::max(worst, 1.02 * (edge.at(t) - vertex.point).norm() + 1e-8);
    for (const EdgeOnFace& use : edge.uses)
        worst = std::max(worst, 1.02 * (point(use, t) - vertex.point).norm() + 1e-8);
    vertex.tolerance = std::max(vertex.tolerance, worst);
}

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/washers.h"
#include "sheetmorph/cad/carry/washer_region.h"
#include "sheetmorph/cad/meshing/occt_surface.h"
#include "sheetmorph/cad/splines/spline_curve.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Line.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>

namespace sheetmorph::cad
{

namespace
{

// A changed mesh, and the shape rebuilt around divided faces.
class Divider
{
public:
    Divider(const ShapeMesh& mesh, double accuracy)
        : before_(mesh), mesh_(std::make_shared<ShapeMesh>(mesh)), accuracy_(accuracy)
    {
    }

    void divide(int face, const FaceTriangles& triangles, const std::vector<WasherRegion>& regions)
    {
        const TopoDS_Face& whole = TopoDS::Face(before_.faces(face + 1));
        TopoDS_Face rest = like(whole);
        std::vector<TopoDS_Face> made;
        std::set<int> taken;
        for (const WasherRegion& region : regions)
        {
            TopoDS_Face washer = like(whole);
            add_wires(washer, whole, [&](int wire) { return region.wires.count(wire) > 0; });
            const std::vector<TopoDS_Edge> ring = edges_along(region.outline, triangles, whole);
            add_ring(washer, ring, false);
            add_ring(rest, ring, true);
            taken.insert(region.wires.begin(), region.wires.end());
            note_triangles(region, triangles);
            made.push_back(TopoDS::Face(washer.Oriented(whole.Orientation())));
        }
        add_wires(rest, whole, [&](int wire) { return taken.count(wire) == 0; });
        keep_vertices_of(face);
        found_.replaced.Bind(whole, rest);
        for (const TopoDS_Face& washer : made)
            found_.washers.emplace_back(whole, washer);
    }

    WasheredMesh result()
    {
        mesh_->shape = rebuilt(before_.shape);
        TopTools_IndexedMapOfShape faces;
        for (int f = 1; f <= before_.faces.Extent(); ++f)
        {
            const TopoDS_Shape& face = before_.faces(f);
            faces.Add(rebuilt(face));
        }
        for (const auto& [whole, washer] : found_.washers)
            faces.Add(washer);
        mesh_->faces = faces;
        found_.mesh = mesh_;
        return std::move(found_);
    }

private:
    TopoDS_Face like(const TopoDS_Face& face) const
    {
        TopLoc_Location place;
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
        TopoDS_Face made;
        builder_.MakeFace(made, surface, place, BRep_Tool::Tolerance(face));
        return made;
    }

    template <typename IsWanted>
    void add_wires(TopoDS_Face& face, const TopoDS_Face& whole, const IsWanted& is_wanted) const
    {
        int wire = 0;
        for (TopoDS_Iterator it(whole.Oriented(TopAbs_FORWARD)); it.More(); it.Next(), ++wire)
            if (is_wanted(wire))
                builder_.Add(face, it.Value());
    }

    void add_ring(TopoDS_Face& face, const std::vector<TopoDS_Edge>& ring, bool is_reversed) const
    {
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (const TopoDS_Edge& edge : ring)
            builder_.Add(wire, edge);
        wire.Closed(true);
        builder_.Add(face, is_reversed ? wire.Reversed() : TopoDS_Shape(wire));
    }

    TopoDS_Vertex vertex_at(int vertex)
    {
        TopoDS_Vertex made;
        const auto at = before_.rest.row(vertex);
        builder_.MakeVertex(made, gp_Pnt(at(0), at(1), at(2)), accuracy_);
        mesh_->vertices.Add(made);
        mesh_->on_vertex.push_back(vertex);
        return made;
    }

    std::vector<TopoDS_Edge> edges_along(const VertexIds& outline, const FaceTriangles& triangles,
                                         const TopoDS_Face& face)
    {
        std::vector<TopoDS_Vertex> corners;
        for (const int vertex : outline)
            corners.push_back(vertex_at(vertex));
        std::vector<TopoDS_Edge> edges;
        for (std::size_t i = 0; i < outline.size(); ++i)
        {
            const std::size_t next = (i + 1) % outline.size();
            const Vector2 from = triangles.parameters().at(outline[i]),
                          to = triangles.parameters().at(outline[next]);
            const double length = (to - from).norm();
            TopoDS_Edge edge = edge_between(from, to, face);
            builder_.Add(edge, corners[i].Oriented(TopAbs_FORWARD));
            builder_.Add(edge, corners[next].Oriented(TopAbs_REVERSED));
            builder_.Range(edge, 0.0, length);
            mesh_->edges.Add(edge);
            mesh_->on_edge.push_back({{outline[i], outline[next]}, {0.0, length}});
            edges.push_back(edge);
        }
        return edges;
    }

    // An edge that is straight in the parameters of a face.
    TopoDS_Edge edge_between(const Vector2& from, const Vector2& to, const TopoDS_Face& face) const
    {
        TopLoc_Location place;
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
        const Handle(Geom_Surface) there = placed_surface(face);
        const double length = (to - from).norm();
        const Vector2 along = (to - from) / length;
        const Handle(Geom2d_Line) track =
            new Geom2d_Line(gp_Pnt2d(from(0), from(1)), gp_Dir2d(along(0), along(1)));
        const auto point = [&](double t) -> Vector3
        {
            const Vector2 uv = from + t * along;
            return to_vector(there->Value(uv(0), uv(1)).XYZ());
        };
        Handle(Geom_Curve) curve;
        const Vector3 chord = point(length) - point(0.0);
        if (GeomAdaptor_Surface(there).GetType() == GeomAbs_Plane
            && std::abs(chord.norm() - length) < 1e-12 * length)
        {
            const Vector3 start = point(0.0);
            curve = new Geom_Line(gp_Pnt(start(0), start(1), start(2)),
                                  gp_Dir(chord(0), chord(1), chord(2)));
        }
        else
            curve = curve_near(point, CubicBasis(0.0, length), accuracy_).curve();
        TopoDS_Edge edge;
        builder_.MakeEdge(edge, curve, 2.0 * accuracy_);
        builder_.UpdateEdge(edge, track, surface, place, 2.0 * accuracy_);
        return edge;
    }

    void note_triangles(const WasherRegion& region, const FaceTriangles& triangles)
    {
        const auto washer = static_cast<int>(mesh_->on_face.size());
        std::set<int> inside;
        for (const int t : region.triangles)
        {
            mesh_->face_of_triangle[static_cast<std::size_t>(t)] = washer;
            for (int k = 0; k < 3; ++k)
                inside.insert(before_.triangles(t, k));
        }
        VerticesOnFace here;
        for (const int vertex : inside)
        {
            here.vertices.push_back(vertex);
            here.parameters.push_back(triangles.parameters().at(vertex));
        }
        mesh_->on_face.push_back(std::move(here));
    }

    // Removes vertices of a face that its remaining triangles do not use.
    void keep_vertices_of(int face)
    {
        std::set<int> own;
        for (Eigen::Index t = 0; t < before_.triangles.rows(); ++t)
            if (mesh_->face_of_triangle[static_cast<std::size_t>(t)] == face)
                for (int k = 0; k < 3; ++k)
                    own.insert(before_.triangles(t, k));
        const VerticesOnFace& all = before_.on_face[static_cast<std::size_t>(face)];
        VerticesOnFace left;
        for (std::size_t i = 0; i < all.vertices.size(); ++i)
            if (own.count(all.vertices[i]) > 0)
            {
                left.vertices.push_back(all.vertices[i]);
                left.parameters.push_back(all.parameters[i]);
            }
        mesh_->on_face[static_cast<std::size_t>(face)] = std::move(left);
    }

    // A shape that contains divided faces, rebuilt; other shapes unchanged.
    TopoDS_Shape rebuilt(const TopoDS_Shape& shape)
    {
        const bool is_group = shape.ShapeType() < TopAbs_FACE;
        if (!is_group && !found_.replaced.IsBound(shape))
            return shape;
        if (!found_.replaced.IsBound(shape))
        {
            TopoDS_Shape made = shape.EmptyCopied();
            made.Location(TopLoc_Location());
            made.Orientation(TopAbs_FORWARD);
            for (TopoDS_Iterator it(shape, false, true); it.More(); it.Next())
            {
                builder_.Add(made, rebuilt(it.Value()));
                for (const auto& [whole, washer] : found_.washers)
                    if (whole.IsSame(it.Value()))
                        builder_.Add(made, washer.Oriented(it.Value().Orientation()));
            }
            made.Closed(shape.Closed());
            found_.replaced.Bind(shape, made);
        }
        return found_.replaced.Find(shape).Oriented(shape.Orientation());
    }

    const ShapeMesh& before_;
    std::shared_ptr<ShapeMesh> mesh_;
    double accuracy_;
    BRep_Builder builder_;
    WasheredMesh found_;
};

// The faces on both sides of every edge.
std::vector<std::set<int>> faces_at_edges(const ShapeMesh& mesh)
{
    std::vector<std::set<int>> found(static_cast<std::size_t>(mesh.edges.Extent()));
    for (int f = 0; f < mesh.faces.Extent(); ++f)
        for (TopExp_Explorer it(mesh.faces(f + 1), TopAbs_EDGE); it.More(); it.Next())
            found[static_cast<std::size_t>(mesh.edges.FindIndex(it.Current()) - 1)].insert(f);
    return found;
}

std::vector<std::vector<int>> triangles_of_faces(const ShapeMesh& mesh)
{
    std::vector<std::vector<int>> found(static_cast<std::size_t>(mesh.faces.Extent()));
    for (std::size_t t = 0; t < mesh.face_of_triangle.size(); ++t)
        found[static_cast<std::size_t>(mesh.face_of_triangle[t])].push_back(static_cast<int>(t));
    return found;
}

}  // namespace

WasheredMesh divide_along_washers(const ShapeMesh& mesh, const Points& result,
                                  const FaceMotions& motions, const WasherTolerances& tolerances)
{
    const std::vector<std::vector<int>> triangles = triangles_of_faces(mesh);
    const std::vector<std::set<int>> beside = faces_at_edges(mesh);
    Divider divider(mesh, tolerances.edge);
    bool is_any = false;
    for (int f = 0; f < mesh.faces.Extent(); ++f)
    {
        const auto i = static_cast<std::size_t>(f);
        if (motions[i])
            continue;
        FaceTriangles own(mesh, f, triangles[i]);
        std::vector<WasherRegion> regions;
        const auto take = [&](int edge, const KeptMotion& motion)
        {
            std::set<int> moved;
            for (const int v : mesh.on_face[i].vertices)
                if ((motion.point(mesh.rest.row(v).transpose()) - result.row(v).transpose()).norm()
                    <= tolerances.rigid)
                    moved.insert(v);
            const VertexIds& seeds = mesh.on_edge[static_cast<std::size_t>(edge)].vertices;
            if (const auto region = own.around(seeds, moved); region && own.take(region->triangles))
                regions.push_back(*region);
        };
        for (TopExp_Explorer it(mesh.faces(f + 1), TopAbs_EDGE); it.More(); it.Next())
        {
            const int edge = mesh.edges.FindIndex(it.Current()) - 1;
            for (const int other : beside[static_cast<std::size_t>(edge)])
                if (const auto& motion = motions[static_cast<std::size_t>(other)];
                    motion && motion->scale == 1.0)
                    take(edge, *motion);
        }
        if (!regions.empty())
            divider.divide(f, own, regions);
        is_any = is_any || !regions.empty();
    }
    return is_any ? divider.result() : WasheredMesh{};
}

}  // namespace sheetmorph::cad

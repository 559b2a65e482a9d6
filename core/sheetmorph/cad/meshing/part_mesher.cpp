// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/part_mesher.h"
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/meshing/face_nodes.h"
#include "sheetmorph/cad/meshing/occt_surface.h"
#include "sheetmorph/cad/meshing/shape_mesh.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <OSD_Parallel.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <gp_Circ.hxx>
#include <map>

namespace sheetmorph::cad
{

namespace
{

// A spline surface that is a plane, cylinder, ... within this (mm) counts as one. Chosen: a hundred
// times the tolerance of OpenCASCADE (1e-7), and far below any tolerance of sheet metal.
constexpr double recognition_tolerance = 1e-5;

// A face, remeshed.
struct MeshedFace
{
    std::vector<Vector3> points;
    std::vector<Vector2> parameters;  // of the points; empty if unknown
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> shared;  // (point, its number in SharedVertices)
    CadSurface surface;
    double deviation = 0.0;
    Convergence convergence = {};
};

void take(MeshedFace& face, const FaceMesh& mesh)
{
    face.points.clear();
    face.parameters.clear();
    face.triangles.clear();
    for (const FaceVertex& vertex : mesh.vertices())
    {
        face.points.push_back(vertex.point);
        face.parameters.push_back(vertex.uv);
    }
    for (const FaceMesh::Triangle& triangle : mesh.triangles())
        if (triangle.is_alive())
            face.triangles.push_back(triangle.corner);
}

MeshedFace mesh_face(const TopoDS_Face& face, const SharedVertices& shared,
                     const CadMeshing& meshing, const StopFlag* stop)
{
    FaceNodes nodes = face_nodes(face, shared);
    MeshedFace made;
    made.surface = describe_surface(face, recognition_tolerance);
    made.triangles = nodes.triangles;
    made.shared = nodes.shared;
    for (const FaceVertex& vertex : nodes.vertices)
        made.points.push_back(vertex.point);
    if (!nodes.has_parameters || nodes.triangles.empty())
        return made;
    for (const FaceVertex& vertex : nodes.vertices)
        made.parameters.push_back(vertex.uv);
    const OcctSurface surface(face);
    for (FaceVertex& vertex : nodes.vertices)
        vertex.normal = surface_normal(surface, vertex.uv);
    FaceSizes sizes;
    sizes.edge = meshing.edge;
    sizes.deflection = meshing.deflection;
    sizes.angle = meshing.angle;
    sizes.stop = stop;
    try
    {
        FaceMesh mesh(std::move(nodes.vertices), nodes.triangles, nodes.locked);
        made.convergence = refine_face(mesh, surface, sizes);
        made.deviation = deviation(mesh, surface);
        take(made, mesh);
    }
    catch (const InvalidInput&)
    {
        // A triangulation that is no surface stays as BRepMesh made it.
    }
    return made;
}

// Gives the points of all faces their place in one mesh.
class Welder
{
public:
    Welder(const std::vector<MeshedFace>& faces, int shared_count)
        : faces_(faces),
          sets_(shared_count),
          place_(static_cast<std::size_t>(shared_count), -1),
          on_face_(faces.size())
    {
        for (const MeshedFace& face : faces)
        {
            std::map<int, int> first;
            for (const auto& [point, number] : face.shared)
                if (const auto [found, is_new] = first.emplace(point, number); !is_new)
                    sets_.join(found->second, number);
        }
        for (std::size_t f = 0; f < faces.size(); ++f)
            add(static_cast<int>(f));
    }

    //! The vertex of a number in SharedVertices; -1 if no triangle has it.
    int place(int number) { return place_[static_cast<std::size_t>(sets_.root(number))]; }

    mesh::TriangleMesh mesh() const
    {
        Points points(static_cast<Eigen::Index>(points_.size()), 3);
        for (std::size_t i = 0; i < points_.size(); ++i)
            points.row(static_cast<Eigen::Index>(i)) = points_[i].transpose();
        Triangles triangles(static_cast<Eigen::Index>(triangles_.size()), 3);
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            for (int k = 0; k < 3; ++k)
                triangles(static_cast<Eigen::Index>(i), k) =
                    triangles_[i][static_cast<std::size_t>(k)];
        return {points, triangles};
    }

    const std::vector<int>& face_of_triangle() const { return face_of_triangle_; }
    const std::vector<VerticesOnFace>& on_face() const { return on_face_; }

private:
    void add(int f)
    {
        const MeshedFace& face = faces_[static_cast<std::size_t>(f)];
        std::vector<int> number(face.points.size(), -1), vertex(face.points.size(), -1);
        for (const auto& [point, shared] : face.shared)
            number[static_cast<std::size_t>(point)] = sets_.root(shared);
        for (const auto& corners : face.triangles)
        {
            std::array<int, 3> row{};
            for (std::size_t k = 0; k < 3; ++k)
            {
                const auto point = static_cast<std::size_t>(corners[k]);
                int& placed = number[point] < 0 ? vertex[point]
                                                : place_[static_cast<std::size_t>(number[point])];
                if (placed < 0)
                {
                    placed = static_cast<int>(points_.size());
                    points_.push_back(face.points[point]);
                }
                row[k] = placed;
            }
            // At a pole, or where edges shrink to a point, triangles have no extent.
            if (row[0] == row[1] || row[1] == row[2] || row[2] == row[0])
                continue;
            triangles_.push_back(row);
            face_of_triangle_.push_back(f);
        }
        for (std::size_t point = 0; point < face.parameters.size(); ++point)
        {
            const int placed =
                number[point] < 0 ? vertex[point] : place_[static_cast<std::size_t>(number[point])];
            if (placed < 0)
                continue;
            VerticesOnFace& here = on_face_[static_cast<std::size_t>(f)];
            here.vertices.push_back(placed);
            here.parameters.push_back(face.parameters[point]);
        }
    }

    const std::vector<MeshedFace>& faces_;
    DisjointSets sets_;
    std::vector<int> place_;
    std::vector<Vector3> points_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<int> face_of_triangle_;
    std::vector<VerticesOnFace> on_face_;
};

std::vector<CadCircle> circles_of(const SharedVertices& shared, Welder& welder)
{
    std::vector<CadCircle> circles;
    for (int i = 1; i <= shared.edges().Extent(); ++i)
    {
        const TopoDS_Edge& edge = TopoDS::Edge(shared.edges()(i));
        if (BRep_Tool::Degenerated(edge))
            continue;
        const BRepAdaptor_Curve curve(edge);
        if (curve.GetType() != GeomAbs_Circle)
            continue;
        const gp_Circ circle = curve.Circle();
        CadCircle found{to_vector(circle.Location().XYZ()),
                        to_vector(circle.Axis().Direction().XYZ()),
                        circle.Radius(),
                        {}};
        for (const int number : shared.along(edge, 0))
            if (const int vertex = welder.place(number); vertex >= 0)
                found.vertices.push_back(vertex);
        std::sort(found.vertices.begin(), found.vertices.end());
        const auto end = std::unique(found.vertices.begin(), found.vertices.end());
        found.vertices.erase(end, found.vertices.end());
        circles.push_back(found);
    }
    return circles;
}

// The vertices along every edge, and those at its ends.
void note_edges(ShapeMesh& known, const SharedVertices& shared, Welder& welder)
{
    known.edges = shared.edges();
    known.on_edge.resize(static_cast<std::size_t>(known.edges.Extent()));
    for (int i = 1; i <= known.edges.Extent(); ++i)
    {
        const TopoDS_Edge& edge = TopoDS::Edge(known.edges(i));
        const std::vector<double>& parameters = shared.parameters(i - 1);
        VerticesOnEdge& here = known.on_edge[static_cast<std::size_t>(i - 1)];
        if (!BRep_Tool::Degenerated(edge))
            for (const int number : shared.along(edge, static_cast<int>(parameters.size())))
                here.vertices.push_back(welder.place(number));
        const auto end = here.vertices.end();
        if (std::find(here.vertices.begin(), end, -1) != end)
            here.vertices.clear();
        if (!here.vertices.empty())
            here.parameters = parameters;
    }
    known.vertices = shared.vertices();
    for (int i = 0; i < known.vertices.Extent(); ++i)
        known.on_vertex.push_back(welder.place(i));
}

bool has_no_border(const Triangles& triangles)
{
    std::map<std::pair<int, int>, int> balance;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    return std::all_of(balance.begin(), balance.end(),
                       [](const auto& side) { return side.second == 0; });
}

double signed_volume(const mesh::TriangleMesh& mesh)
{
    double volume = 0.0;
    const Vector3 centre = mesh.points().colwise().mean();
    for (Eigen::Index t = 0; t < mesh.triangles().rows(); ++t)
    {
        const auto corner = [&](int k) -> Vector3
        { return mesh.points().row(mesh.triangles()(t, k)).transpose() - centre; };
        volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
    }
    return volume;
}

mesh::TriangleMesh turned_over(const mesh::TriangleMesh& mesh)
{
    Triangles triangles = mesh.triangles();
    triangles.col(1).swap(triangles.col(2));
    return {mesh.points(), triangles};
}

std::shared_ptr<const ShapeMesh> with_mesh(ShapeMesh known, const CadPart& part)
{
    known.rest = part.mesh.points();
    known.triangles = part.mesh.triangles();
    known.face_of_triangle = part.face_of_triangle;
    return std::make_shared<const ShapeMesh>(std::move(known));
}

std::vector<MeshedFace> mesh_faces(const TopTools_IndexedMapOfShape& shapes,
                                   const SharedVertices& shared, const CadMeshing& meshing,
                                   const StopFlag* stop)
{
    std::vector<MeshedFace> faces(static_cast<std::size_t>(shapes.Extent()));
    const auto work = [&](int f)
    {
        const TopoDS_Face& face = TopoDS::Face(shapes(f + 1));
        MeshedFace& made = faces[static_cast<std::size_t>(f)];
        try
        {
            stop_if(stop);
            made = mesh_face(face, shared, meshing, stop);
        }
        catch (const Cancelled&)
        {
            return;  // it would end the threads of OpenCASCADE; see below
        }
        if (face.Orientation() == TopAbs_REVERSED)
            for (auto& corners : made.triangles)
                std::swap(corners[1], corners[2]);
    };
    OSD_Parallel::For(0, shapes.Extent(), work);
    stop_if(stop);
    return faces;
}

}  // namespace

CadPart mesh_part(const TopoDS_Shape& shape, const CadMeshing& meshing, const StopFlag* stop)
{
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(shape, TopAbs_FACE, shapes);
    const SharedVertices shared(shape);
    const std::vector<MeshedFace> faces = mesh_faces(shapes, shared, meshing, stop);
    CadPart part;
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
        part.surfaces.push_back(faces[f].surface);
        part.deviation = std::max(part.deviation, faces[f].deviation);
        part.convergence.join(faces[f].convergence);
        if (faces[f].triangles.empty())
            part.skipped_faces.push_back(static_cast<int>(f));
    }
    Welder welder(faces, shared.count());
    part.mesh = welder.mesh();
    part.face_of_triangle = welder.face_of_triangle();
    part.circles = circles_of(shared, welder);
    part.is_closed = part.mesh.triangle_count() > 0 && has_no_border(part.mesh.triangles());
    if (part.is_closed && signed_volume(part.mesh) < 0)
        part.mesh = turned_over(part.mesh);
    ShapeMesh known{shape, shapes, {}, {}, welder.on_face(), {}, {}, {}, {}, {}};
    note_edges(known, shared, welder);
    part.known = with_mesh(std::move(known), part);
    return part;
}

}  // namespace sheetmorph::cad

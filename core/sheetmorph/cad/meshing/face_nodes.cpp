// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/face_nodes.h"
#include "sheetmorph/cad/meshing/occt_surface.h"

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

namespace sheetmorph::cad
{

namespace
{

Handle(Poly_PolygonOnTriangulation) polygon_of(const TopoDS_Edge& edge, const TopoDS_Face& face)
{
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull())
        return {};
    return BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
}

// Adds the sides of one edge to those that stay, and their lengths to the sizes at their ends.
void lock_sides(FaceNodes& nodes, const Poly_PolygonOnTriangulation& polygon,
                std::vector<int>& uses)
{
    for (int i = 1; i < polygon.NbNodes(); ++i)
    {
        const int a = polygon.Node(i) - 1, b = polygon.Node(i + 1) - 1;
        nodes.locked.emplace_back(a, b);
        FaceVertex& one = nodes.vertices[static_cast<std::size_t>(a)];
        FaceVertex& other = nodes.vertices[static_cast<std::size_t>(b)];
        one.is_fixed = other.is_fixed = true;
        const double length = (one.point - other.point).norm();
        if (!(length > 0))
            continue;
        for (const int v : {a, b})
        {
            nodes.vertices[static_cast<std::size_t>(v)].size += length;
            ++uses[static_cast<std::size_t>(v)];
        }
    }
}

void read_edges(FaceNodes& nodes, const TopoDS_Face& face, const SharedVertices& shared)
{
    std::vector<int> uses(nodes.vertices.size(), 0);
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        const Handle(Poly_PolygonOnTriangulation) polygon = polygon_of(edge, face);
        if (polygon.IsNull())
            continue;
        lock_sides(nodes, *polygon, uses);
        const VertexIds numbers = shared.along(edge, polygon->NbNodes());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            nodes.shared.push_back({polygon->Node(static_cast<int>(i) + 1) - 1, numbers[i]});
    }
    for (std::size_t v = 0; v < uses.size(); ++v)
        if (uses[v] > 0)
            nodes.vertices[v].size /= uses[v];
}

}  // namespace

SharedVertices::SharedVertices(const TopoDS_Shape& shape)
{
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    count_ = vertices_.Extent();
    first_.assign(static_cast<std::size_t>(edges_.Extent()), 0);
    pieces_.assign(first_.size(), 0);
    parameters_.resize(first_.size());
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
        for (TopExp_Explorer it(faces.Current(), TopAbs_EDGE); it.More(); it.Next())
        {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            const auto index = static_cast<std::size_t>(edges_.FindIndex(edge) - 1);
            const auto polygon = polygon_of(edge, TopoDS::Face(faces.Current()));
            if (pieces_[index] > 0 || polygon.IsNull())
                continue;
            pieces_[index] = polygon->NbNodes();
            first_[index] = count_;
            for (int i = 1; polygon->HasParameters() && i <= polygon->NbNodes(); ++i)
                parameters_[index].push_back(polygon->Parameter(i));
            count_ += BRep_Tool::Degenerated(edge) ? 0 : polygon->NbNodes() - 2;
        }
}

int SharedVertices::number_of(const TopoDS_Vertex& vertex) const
{
    return vertices_.FindIndex(vertex) - 1;
}

VertexIds SharedVertices::along(const TopoDS_Edge& edge, int wanted) const
{
    const int index = edges_.FindIndex(edge) - 1;
    TopoDS_Vertex first, last;
    TopExp::Vertices(edge, first, last);
    if (index < 0 || first.IsNull() || last.IsNull()
        || (wanted > 0 && pieces_[static_cast<std::size_t>(index)] != wanted))
        return {};
    const int count = pieces_[static_cast<std::size_t>(index)];
    if (BRep_Tool::Degenerated(edge))
        return VertexIds(static_cast<std::size_t>(count), number_of(first));
    VertexIds numbers;
    for (int i = 0; i < count; ++i)
        numbers.push_back(i == 0           ? number_of(first)
                          : i == count - 1 ? number_of(last)
                                           : first_[static_cast<std::size_t>(index)] + i - 1);
    return numbers;
}

FaceNodes face_nodes(const TopoDS_Face& face, const SharedVertices& shared)
{
    FaceNodes nodes;
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull())
        return nodes;
    nodes.has_parameters = mesh->HasUVNodes();
    nodes.vertices.resize(static_cast<std::size_t>(mesh->NbNodes()));
    for (int i = 1; i <= mesh->NbNodes(); ++i)
    {
        FaceVertex& vertex = nodes.vertices[static_cast<std::size_t>(i - 1)];
        vertex.point = to_vector(mesh->Node(i).Transformed(location).XYZ());
        if (nodes.has_parameters)
            vertex.uv = Vector2(mesh->UVNode(i).X(), mesh->UVNode(i).Y());
    }
    for (int i = 1; i <= mesh->NbTriangles(); ++i)
    {
        std::array<int, 3> corners{};
        mesh->Triangle(i).Get(corners[0], corners[1], corners[2]);
        nodes.triangles.push_back({corners[0] - 1, corners[1] - 1, corners[2] - 1});
    }
    read_edges(nodes, face, shared);
    return nodes;
}

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/cad_meshing.h"
#include "sheetmorph/cad/meshing/face_mesh.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

namespace sheetmorph::cad
{

//! The vertices and edges of a shape, and the numbers of the mesh vertices on them.
class SharedVertices
{
public:
    //! \param shape  one that triangulate() has been through
    explicit SharedVertices(const TopoDS_Shape& shape);

    int count() const { return count_; }

    //! The numbers along an edge, its ends included; as many as wanted for the edge's first face.
    //! \returns empty if the edge is unknown, or was cut into another number of pieces
    VertexIds along(const TopoDS_Edge& edge, int wanted) const;

    const TopTools_IndexedMapOfShape& edges() const { return edges_; }
    const TopTools_IndexedMapOfShape& vertices() const { return vertices_; }

    //! The parameters along an edge, counted from 0, of the vertices that along() numbers.
    const std::vector<double>& parameters(int edge) const
    {
        return parameters_[static_cast<std::size_t>(edge)];
    }

private:
    int number_of(const TopoDS_Vertex& vertex) const;

    TopTools_IndexedMapOfShape vertices_, edges_;
    std::vector<int> first_;   // number of the first inner vertex of every edge
    std::vector<int> pieces_;  // vertices along every edge, 0 if it has no polygon
    std::vector<std::vector<double>> parameters_;
    int count_ = 0;
};

//! A face as BRepMesh left it.
struct FaceNodes
{
    std::vector<FaceVertex> vertices;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::pair<int, int>> locked;  //!< the sides on edges of the face
    std::vector<std::array<int, 2>> shared;   //!< (vertex, its number in SharedVertices)
    bool has_parameters = false;              //!< whether uv is known
};

//! \returns no triangles if the face has none
FaceNodes face_nodes(const TopoDS_Face& face, const SharedVertices& shared);

}  // namespace sheetmorph::cad

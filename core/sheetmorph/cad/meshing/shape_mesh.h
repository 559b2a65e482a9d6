// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/face_mesh.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace sheetmorph::cad
{

//! Vertices of a mesh on one face of a shape, and their parameters there; on a seam one comes
//! twice.
struct VerticesOnFace
{
    VertexIds vertices;
    std::vector<Vector2> parameters;
};

//! Vertices of a mesh along one edge of a shape, its ends included, and their parameters there.
struct VerticesOnEdge
{
    VertexIds vertices;
    std::vector<double> parameters;  //!< ascending
};

//! What the mesher knows of the mesh that it made of a shape. All is in the coordinates of the
//! shape without a placement.
struct ShapeMesh
{
    TopoDS_Shape shape;
    TopTools_IndexedMapOfShape faces, edges, vertices;
    std::vector<VerticesOnFace> on_face;  //!< one a face; empty if its parameters are unknown
    std::vector<VerticesOnEdge> on_edge;  //!< one an edge; empty for one without extent
    VertexIds on_vertex;                  //!< one a vertex; -1 if no triangle has it
    Points rest;                          //!< (n, 3) of the mesh, mm
    Triangles triangles;                  //!< (m, 3) of the mesh
    std::vector<int> face_of_triangle;    //!< (m)
};

}  // namespace sheetmorph::cad

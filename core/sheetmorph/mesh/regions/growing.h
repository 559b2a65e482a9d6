// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! Every function here takes ids in any order, repeated or not, and returns them ascending, once.
//! All throw InvalidInput that names ids outside the mesh.

//! The vertices and all that share a triangle with them, `rings` times over; rings >= 0.
VertexIds grow_rings(const TriangleMesh& mesh, const VertexIds& vertices, int rings);

//! The vertices without those that share a triangle with a vertex outside, `rings` times over.
//! The border of the mesh does not shrink by itself.
VertexIds shrink_rings(const TriangleMesh& mesh, const VertexIds& vertices, int rings);

//! The triangles reached from one across edges at which the sheet bends by less than `max_angle`
//! (radians, between the planes, 0 flat, pi folded back), however the triangles are oriented.
//! Triangles too thin to have a plane are crossed, and carry the plane they were reached from.
std::vector<int> grow_to_creases(const TriangleMesh& mesh, int triangle, double max_angle);
std::vector<int> grow_to_creases(const TriangleMesh& mesh, const EdgeTable& table, int triangle,
                                 double max_angle);

//! The triangles connected with one through shared vertices: its connected component.
std::vector<int> connected_triangles(const TriangleMesh& mesh, int triangle);

//! The triangles whose three corners are all among the vertices.
std::vector<int> triangles_with_all_vertices(const TriangleMesh& mesh, const VertexIds& vertices);

//! The corners of the triangles.
VertexIds vertices_of_triangles(const TriangleMesh& mesh, const std::vector<int>& triangles);

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! All functions take ids in any order with repetitions and return them ascending without
//! repetitions. They throw InvalidInput naming ids outside the mesh.

//! Adds all vertices that share a triangle with the set, `rings` times; rings >= 0.
VertexIds grow_rings(const TriangleMesh& mesh, const VertexIds& vertices, int rings);

//! Removes all vertices that share a triangle with a vertex outside the set, `rings` times. The
//! border of the mesh alone does not make the set shrink.
VertexIds shrink_rings(const TriangleMesh& mesh, const VertexIds& vertices, int rings);

//! The triangles reached from one triangle across edges that bend by less than `max_angle`
//! (radians; 0: flat, pi: folded back). The orientation of the triangles has no effect. A
//! degenerate triangle is crossed with the plane of the triangle before it.
std::vector<int> grow_to_creases(const TriangleMesh& mesh, int triangle, double max_angle);
std::vector<int> grow_to_creases(const TriangleMesh& mesh, const EdgeTable& table, int triangle,
                                 double max_angle);

//! The connected component of a triangle, through shared vertices.
std::vector<int> connected_triangles(const TriangleMesh& mesh, int triangle);

//! The triangles whose three corners are all among the vertices.
std::vector<int> triangles_with_all_vertices(const TriangleMesh& mesh, const VertexIds& vertices);

//! The corners of the triangles.
VertexIds vertices_of_triangles(const TriangleMesh& mesh, const std::vector<int>& triangles);

}  // namespace sheetmorph::mesh

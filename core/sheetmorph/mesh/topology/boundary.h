// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! An edge with exactly one triangle, in that triangle's direction.
struct BoundaryEdge
{
    int from, to;
    int triangle;
};

//! The boundary edges of any triangles, ordered by (smaller vertex, larger vertex). Triangles that
//! repeat a vertex are ignored, and duplicate triangles count once.
std::vector<BoundaryEdge> boundary_edges(const TriangleMesh& mesh);

//! The closed loops of boundary edges: each vertex once, in order along the rim.
//! A loop starts at its smallest vertex and follows the direction of most of its triangles: the
//! sheet is on the left, seen against the normals. Loops are ordered by first vertex. Loops that
//! touch in a vertex are separated, so two holes that meet in a vertex give two loops. A chain that
//! ends where three sheets meet (a T-joint) is not closed and is omitted.
std::vector<VertexIds> boundary_loops(const TriangleMesh& mesh);

//! The loop through a vertex; of several loops the one with the fewest vertices (the hole, not the
//! border).
//! \throws InvalidInput if the vertex does not exist or is not on a closed boundary loop
VertexIds boundary_loop_at(const TriangleMesh& mesh, int vertex);

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! An edge that exactly one triangle uses, in that triangle's direction.
struct BoundaryEdge
{
    int from, to;
    int triangle;
};

//! The boundary edges of any triangles, by rising (smaller vertex, larger vertex). Triangles that
//! repeat a vertex are left out, and a triangle given twice counts once.
std::vector<BoundaryEdge> boundary_edges(const TriangleMesh& mesh);

//! The closed loops of boundary edges: each vertex once, in order along the rim.
//! A loop starts at its smallest vertex and runs as most of its triangles do (the sheet on the
//! left, seen against the normals); loops come by rising first vertex. Where several loops touch in
//! a vertex each gets its own, so that two holes that meet in a vertex are two loops. A chain of
//! boundary edges that ends where three sheets meet (a T-joint) closes no loop and is left out.
std::vector<VertexIds> boundary_loops(const TriangleMesh& mesh);

//! The loop through a vertex; of several the one with the fewest vertices (the hole, not the
//! border). \throws InvalidInput if the vertex does not exist or is on no closed boundary loop
VertexIds boundary_loop_at(const TriangleMesh& mesh, int vertex);

}  // namespace sheetmorph::mesh

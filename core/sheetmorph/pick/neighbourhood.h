// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"
#include "sheetmorph/mesh/topology/vertex_triangles.h"

namespace sheetmorph::pick
{

//! The searches of growing.h on precomputed tables, fast enough for every mouse move. Input ids may
//! be in any order with repetitions; results are ascending without repetitions. All functions throw
//! InvalidInput naming ids outside the mesh.
class Neighbourhood
{
public:
    explicit Neighbourhood(const mesh::TriangleMesh& mesh);

    //! The triangles with a corner among the vertices.
    std::vector<int> triangles_at(const VertexIds& vertices) const;

    //! As grow_rings() and shrink_rings(); `rings` >= 0.
    VertexIds grown(const VertexIds& vertices, int rings) const;
    VertexIds shrunk(const VertexIds& vertices, int rings) const;

    //! The face around a triangle, bounded by creases of `max_angle` radians or more; as
    //! grow_to_creases().
    std::vector<int> face(int triangle, double max_angle) const;

    //! The triangles connected with a triangle; as connected_triangles().
    std::vector<int> piece(int triangle) const;

    //! The connected components of some vertices, ordered by first vertex. Vertices are neighbours
    //! if they share a triangle.
    std::vector<VertexIds> pieces(const VertexIds& vertices) const;

    //! The closed loops of creases; as crease_loops(), `crease` in radians.
    std::vector<VertexIds> rims(double crease) const;

private:
    //! Calls visit(corner) for the corners of all triangles at a vertex.
    template <typename Visit>
    void visit_around(int vertex, Visit&& visit) const;
    void measure_bends();
    double bend(int edge, int triangle, const mesh::EdgeUse& other) const;

    mesh::TriangleMesh mesh_;
    mesh::EdgeTable edges_;
    mesh::VertexTriangles triangles_;
    std::vector<double> bends_;  // radians, at every edge of two triangles
    bool has_thin_ = false;      // whether there are degenerate triangles
};

}  // namespace sheetmorph::pick

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"
#include "sheetmorph/mesh/topology/vertex_triangles.h"

namespace sheetmorph::pick
{

//! What growing.h finds, from tables: fast enough to be asked at every move of the mouse. Ids may
//! be given in any order, repeated or not, and come back ascending, once. All functions throw
//! InvalidInput that names ids outside the mesh.
class Neighbourhood
{
public:
    explicit Neighbourhood(const mesh::TriangleMesh& mesh);

    //! The triangles with a corner among the vertices.
    std::vector<int> triangles_at(const VertexIds& vertices) const;

    //! As grow_rings and shrink_rings; `rings` >= 0.
    VertexIds grown(const VertexIds& vertices, int rings) const;
    VertexIds shrunk(const VertexIds& vertices, int rings) const;

    //! The triangles of the face around one, which ends at creases of `max_angle` radians or more:
    //! as grow_to_creases.
    std::vector<int> face(int triangle, double max_angle) const;

    //! The triangles connected with one: as connected_triangles.
    std::vector<int> piece(int triangle) const;

    //! The connected pieces of some vertices, neighbours being those that share a triangle; by
    //! rising first vertex.
    std::vector<VertexIds> pieces(const VertexIds& vertices) const;

    //! The closed loops of creases: as crease_loops.
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
    bool has_thin_ = false;      // triangles without a plane of their own
};

}  // namespace sheetmorph::pick

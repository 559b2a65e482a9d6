// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/vertex_triangles.h"
#include "sheetmorph/recognise/contacts/contacts.h"
#include "sheetmorph/recognise/facets/facet_graph.h"

namespace sheetmorph::recognise
{

//! A vertex of one part near the surface of another.
struct Touch
{
    int vertex = 0;         //!< of the welded mesh
    int triangle = 0;       //!< of the other part
    double distance = 0.0;  //!< mm
    bool is_edge = false;   //!< it touches with a free edge only, its surface faces elsewhere
};

//! A part prepared for questions about what is near it.
class PartShape
{
public:
    PartShape(const ContactPart& part, double weld);

    const FacetGraph& graph() const { return graph_; }
    const mesh::PickingTree& tree() const { return tree_; }
    const Vector3& low() const { return low_; }
    const Vector3& high() const { return high_; }
    double thickness() const { return thickness_; }
    bool is_free(int vertex) const { return is_free_[vertex] != 0; }

    //! The triangles around a vertex, ascending.
    mesh::VertexTriangles::Range triangles_at(int vertex) const { return triangles_.at(vertex); }

    //! Share of the part's surface that belongs to a vertex, mm^2.
    double area_at(int vertex) const { return area_at_[vertex]; }

    //! The vertices within `reach` of the other part and facing it (radians),
    //! ascending.
    std::vector<Touch> touches(const PartShape& other, double reach, double facing_angle) const;

private:
    bool faces(int vertex, const PartShape& other, int triangle, double cosine) const;
    bool is_sideways(int vertex, const PartShape& other, const mesh::Hit& hit) const;

    FacetGraph graph_;
    mesh::PickingTree tree_;
    Vector3 low_ = Vector3::Zero();
    Vector3 high_ = Vector3::Zero();
    double thickness_;
    mesh::VertexTriangles triangles_;
    std::vector<char> is_free_;
    std::vector<double> area_at_;
};

}  // namespace sheetmorph::recognise

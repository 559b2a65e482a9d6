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
    int vertex = 0;         //!< of the merged mesh
    int triangle = 0;       //!< of the other part
    double distance = 0.0;  //!< mm
    bool is_edge = false;   //!< only a free edge touches; the surface does not face the other part
};

//! A part prepared for proximity queries.
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

    //! The triangles at a vertex, ascending.
    mesh::VertexTriangles::Range triangles_at(int vertex) const { return triangles_.at(vertex); }

    //! A third of the area of the triangles at a vertex, mm^2.
    double area_at(int vertex) const { return area_at_[vertex]; }

    //! The vertices within `reach` (mm) of the other part that face it to within `facing_angle`
    //! (radians), and free edges within `reach`; ascending.
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

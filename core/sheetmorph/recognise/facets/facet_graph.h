// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::recognise
{

//! Two facets that are joined at an edge.
struct FacetJoint
{
    int one, other;
    double bend;    //!< radians between the planes, 0 flat
    double length;  //!< of the edge, mm
};

//! The dual graph of a part: facets with their normals and areas, and the angle between any two
//! facets that share an edge.
class FacetGraph
{
public:
    //! Merges coincident vertices, so that seams of an import are not borders.
    //! \param weld     merging distance, relative to the size of the part
    //! \param scatter  standard deviation of measured vertices, mm; < 0: estimated from the mesh
    FacetGraph(const mesh::TriangleMesh& mesh, double weld, double scatter = -1.0);

    //! The facets of solids. Merges no vertices, and joins facets only where exactly two of them,
    //! consistently oriented, share an edge. Normals of a component that encloses a volume point
    //! outwards. Thin facets have a normal, too.
    static FacetGraph of_solids(const mesh::TriangleMesh& mesh);

    const mesh::TriangleMesh& mesh() const { return welded_; }
    const mesh::EdgeTable& edges() const { return edges_; }
    int triangle_count() const { return welded_.triangle_count(); }

    //! Standard deviation of the vertices about the surface they were measured on, in one
    //! direction, mm; 0 for a mesh that was drawn. Normals and bends are without it, points not.
    double scatter() const { return scatter_; }

    //! What the scatter does to a triangle's normal as it stands, radians.
    double unsure(int triangle) const { return scatter_ > 0.0 ? unsure_[triangle] : 0.0; }

    //! Of length 1; zero for a triangle too thin to have a plane.
    Vector3 normal(int triangle) const { return normals_.row(triangle).transpose(); }
    Vector3 centroid(int triangle) const;
    Vector3 point(int vertex) const { return welded_.points().row(vertex).transpose(); }
    double area(int triangle) const { return areas_[triangle]; }
    bool is_thin(int triangle) const { return areas_[triangle] <= 0.0; }
    double total_area() const { return total_area_; }

    //! Whether the part is closed and its triangles agree on what is outside.
    bool is_solid() const { return is_solid_; }

    //! The connected component of a facet. Components count from 0 in order of first appearance.
    int component(int triangle) const { return component_[triangle]; }
    const std::vector<int>& components() const { return component_; }
    int component_count() const { return static_cast<int>(is_closed_.size()); }

    //! Whether a component is closed: at every edge as many facets run one way as the other.
    bool is_closed(int component) const { return is_closed_[component] != 0; }

    //! All edges where exactly two facets are joined.
    std::vector<FacetJoint> joints() const;

    //! The triangle across side k; where several are, the one that goes straight
    //! on; else -1.
    int across(int triangle, int k) const { return across_[3 * triangle + k]; }

    //! How far the surface bends across side k, radians; pi where nothing is
    //! across.
    double bend(int triangle, int k) const { return bends_[3 * triangle + k]; }

    //! The vertices of the mesh that stand at vertices of the welded one,
    //! ascending.
    VertexIds originals(const VertexIds& vertices) const;

    //! One vertex of the mesh each, the smallest, in the order given.
    VertexIds representatives(const VertexIds& vertices) const;

private:
    FacetGraph(const mesh::TriangleMesh& mesh, double scatter, bool is_oriented);
    void measure_triangles();
    void measure_bends(bool is_oriented);
    void find_components();
    void turn_outwards();
    int side_of(const mesh::EdgeUse& use) const;
    double bend_between(const mesh::EdgeUse& one, const mesh::EdgeUse& other) const;
    void join(const mesh::EdgeUse& one, const mesh::EdgeUse& other);
    void join_straightest(int edge);
    void look_whether_solid();

    mesh::TriangleMesh welded_;
    std::vector<int> representative_;  // of each welded vertex, in the mesh
    std::vector<int> member_starts_;   // of each welded vertex in members_, and the end
    std::vector<int> members_;
    mesh::EdgeTable edges_;
    Points normals_;
    std::vector<double> areas_;
    std::vector<int> across_;
    std::vector<double> bends_;
    double total_area_ = 0.0;
    double scatter_ = 0.0;
    std::vector<double> unsure_;  // empty for a drawn mesh
    bool is_solid_ = false;
    std::vector<int> component_;
    std::vector<char> is_closed_;  // by component
};

//! The label of every triangle's region: triangles belong together across edges
//! that bend by less than `max_angle` radians. Labels from 0 in order of first
//! appearance; triangles too thin to have a plane take that of the triangle
//! they were reached from.
std::vector<int> smooth_regions(const FacetGraph& graph, double max_angle);

}  // namespace sheetmorph::recognise

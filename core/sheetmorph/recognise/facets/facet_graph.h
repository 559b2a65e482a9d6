// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::recognise
{

//! Two facets joined at an edge.
struct FacetJoint
{
    int one, other;
    double bend;    //!< angle between the planes, radians; 0: flat
    double length;  //!< of the edge, mm
};

//! The dual graph of a part: facets with their normals and areas, and the angle between any two
//! facets that share an edge.
class FacetGraph
{
public:
    //! Merges coincident vertices first, because seams of an import are not borders.
    //! \param weld     merging distance, relative to the size of the part
    //! \param scatter  standard deviation of measured vertices, mm; < 0: estimated from the mesh
    FacetGraph(const mesh::TriangleMesh& mesh, double weld, double scatter = -1.0);

    //! The facets of solids. Merges no vertices. Joins facets only where exactly two of them,
    //! consistently oriented, share an edge. The normals of a component that encloses a volume
    //! point outwards. Degenerate facets also have a normal.
    static FacetGraph of_solids(const mesh::TriangleMesh& mesh);

    const mesh::TriangleMesh& mesh() const { return welded_; }
    const mesh::EdgeTable& edges() const { return edges_; }
    int triangle_count() const { return welded_.triangle_count(); }

    //! Standard deviation of the measured vertices about their surface in one direction, mm; 0 for
    //! a drawn mesh. Normals and bends are smoothed to remove it; points are not.
    double scatter() const { return scatter_; }

    //! Standard deviation of a triangle's normal due to the scatter, before smoothing, radians.
    double unsure(int triangle) const { return scatter_ > 0.0 ? unsure_[triangle] : 0.0; }

    //! Unit normal; zero for a degenerate triangle.
    Vector3 normal(int triangle) const { return normals_.row(triangle).transpose(); }
    Vector3 centroid(int triangle) const;
    Vector3 point(int vertex) const { return welded_.points().row(vertex).transpose(); }
    double area(int triangle) const { return areas_[triangle]; }
    bool is_thin(int triangle) const { return areas_[triangle] <= 0.0; }
    double total_area() const { return total_area_; }

    //! Whether the part is closed, apart from small faults, and its normals point outwards.
    bool is_solid() const { return is_solid_; }

    //! The connected component of a facet. Components are numbered from 0 in order of first
    //! appearance.
    int component(int triangle) const { return component_[triangle]; }
    const std::vector<int>& components() const { return component_; }
    int component_count() const { return static_cast<int>(is_closed_.size()); }

    //! Whether, at every edge of a component, equally many facets run in either direction.
    bool is_closed(int component) const { return is_closed_[component] != 0; }

    //! All edges where exactly two facets are joined.
    std::vector<FacetJoint> joints() const;

    //! The triangle across side k, or -1. If there are several, it is the one that continues
    //! straightest.
    int across(int triangle, int k) const { return across_[3 * triangle + k]; }

    //! Angle of the bend across side k, radians; pi if no triangle is across it.
    double bend(int triangle, int k) const { return bends_[3 * triangle + k]; }

    //! The vertices of the mesh that were merged into these vertices, ascending.
    VertexIds originals(const VertexIds& vertices) const;

    //! The smallest vertex of the mesh for each merged vertex, in the given order.
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
    std::vector<int> representative_;  // by merged vertex: a vertex of the mesh
    std::vector<int> member_starts_;   // by merged vertex: its first entry in members_, and the end
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

//! The region of every triangle. Triangles belong to one region if they are connected across edges
//! that bend by less than `max_angle` (radians). Regions are numbered from 0 in order of first
//! appearance. A degenerate triangle takes the region from which it was reached.
std::vector<int> smooth_regions(const FacetGraph& graph, double max_angle);

}  // namespace sheetmorph::recognise

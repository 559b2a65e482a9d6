// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <utility>

namespace sheetmorph
{

//! The triangles of a mesh before they are worked on.
struct WorkingInput
{
    const TriangleMesh& mesh;                        //!< no doubled or repeating triangle
    const std::vector<std::pair<int, int>>& ridges;  //!< (smaller, larger) vertex, sorted
    const std::vector<int>& patch;                   //!< (m)
    const std::vector<double>& sizes;                //!< (n) edge length wanted, mm
    const std::vector<char>& is_flat;                //!< of every patch
    double largest = 0.0;                            //!< edge length wanted far from all ridges, mm
};

//! A manifold copy of a mesh that can be flipped, split and collapsed (CGAL, Surface_mesh). Ridges
//! and the vertices on them stay as they are.
class WorkingMesh
{
public:
    using SurfaceMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
    using Vertex = SurfaceMesh::Vertex_index;
    using Halfedge = SurfaceMesh::Halfedge_index;
    using Edge = SurfaceMesh::Edge_index;
    using Face = SurfaceMesh::Face_index;

    explicit WorkingMesh(const WorkingInput& input);

    Vector3 point(Vertex v) const;
    void move(Vertex v, const Vector3& place);

    //! Twice the area of a face along its normal, or of the triangle over three places.
    Vector3 area_vector(Face face) const;
    static Vector3 area_vector(const Vector3& a, const Vector3& b, const Vector3& c);

    double length(Edge e) const;
    double wanted_length(Edge e) const;

    //! The largest size in the middle of an edge: on a bend it is as curved as at the ends.
    double largest_size(Edge e) const;

    SurfaceMesh surface;
    SurfaceMesh::Property_map<Vertex, int> origin;      //!< vertex of the input, -1 if it is new
    SurfaceMesh::Property_map<Vertex, bool> is_frozen;  //!< on a ridge
    SurfaceMesh::Property_map<Vertex, double> size;     //!< edge length wanted, mm
    SurfaceMesh::Property_map<Edge, bool> is_ridge;
    SurfaceMesh::Property_map<Face, int> patch;

private:
    void mark_ridges(const std::vector<std::pair<int, int>>& ridges);
    void freeze_vertices(const std::vector<int>& original);

    std::vector<char> is_flat_;
    double largest_;
};

//! Turns the edges that are not ridges until every pair of triangles is Delaunay (the two angles
//! opposite an edge sum up to pi at most), or for so many rounds. Pairs that are bent stay.
//! \returns how many edges were turned
int flip_to_delaunay(WorkingMesh& work, int most_rounds = 40);

//! Makes sizes grow slowly along the edges there are now.
void even_sizes(WorkingMesh& work);

//! Splits edges longer than 4/3 of what is wanted, then collapses those shorter than 4/5.
void split_long_edges(WorkingMesh& work);
void collapse_short_edges(WorkingMesh& work);

//! Moves every vertex off the ridges to the middle of the triangles around it, inside its surface.
void smooth(WorkingMesh& work);

}  // namespace sheetmorph

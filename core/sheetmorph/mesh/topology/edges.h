// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! A triangle at an edge; the edge runs from corner `from` to corner `to` of the triangle.
struct EdgeUse
{
    int triangle;
    int from, to;
    int opposite;  //!< the vertex of the triangle that is not on the edge
};

//! The uses of one edge, ordered by opposite vertex.
struct EdgeUses
{
    const EdgeUse* first;
    const EdgeUse* last;

    const EdgeUse* begin() const { return first; }
    const EdgeUse* end() const { return last; }
    int count() const { return static_cast<int>(last - first); }
};

//! The edges of any triangles, ordered by (smaller vertex, larger vertex). A triangle that repeats
//! a vertex has no edges. Of duplicate triangles only the first counts, so that a duplicate element
//! does not hide a border.
class EdgeTable
{
public:
    explicit EdgeTable(const TriangleMesh& mesh);

    int count() const { return static_cast<int>(starts_.size()) - 1; }
    EdgeUses uses(int edge) const;

    //! The edge of side k of a triangle, from its corner k to the next; -1 if the triangle is
    //! ignored.
    int edge_of(int triangle, int k) const { return edge_of_side_[3 * triangle + k]; }

private:
    void sort_uses(const TriangleMesh& mesh);
    void drop_doubled_triangles(const TriangleMesh& mesh);
    void number_edges(const TriangleMesh& mesh);

    std::vector<EdgeUse> uses_;
    std::vector<int> starts_;        // by edge: its first entry in uses_, and the end
    std::vector<int> edge_of_side_;  // 3 per triangle
};

//! Angle between the planes of two triangles at an edge, radians: 0 (flat) to pi (folded onto each
//! other). It does not depend on the orientation of the triangles. 0 if one of them has no extent
//! across the edge.
double bend_angle(const Points& points, const EdgeUse& one, const EdgeUse& other);

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! A triangle at an edge: the edge runs from its corner `from` to its corner `to`.
struct EdgeUse
{
    int triangle;
    int from, to;
    int opposite;  //!< the vertex of the triangle that is not on the edge
};

//! The uses of one edge, by rising opposite vertex.
struct EdgeUses
{
    const EdgeUse* first;
    const EdgeUse* last;

    const EdgeUse* begin() const { return first; }
    const EdgeUse* end() const { return last; }
    int count() const { return static_cast<int>(last - first); }
};

//! The edges of any triangles, by rising (smaller vertex, larger vertex).
//! A triangle that repeats a vertex has no edges; of triangles over the same three vertices only
//! the first counts, so that a doubled element does not hide a border.
class EdgeTable
{
public:
    explicit EdgeTable(const TriangleMesh& mesh);

    int count() const { return static_cast<int>(starts_.size()) - 1; }
    EdgeUses uses(int edge) const;

    //! The edge of side k of a triangle, from its corner k to the next; -1 if it does not count.
    int edge_of(int triangle, int k) const { return edge_of_side_[3 * triangle + k]; }

private:
    void sort_uses(const TriangleMesh& mesh);
    void drop_doubled_triangles(const TriangleMesh& mesh);
    void number_edges(const TriangleMesh& mesh);

    std::vector<EdgeUse> uses_;
    std::vector<int> starts_;        // of each edge in uses_, and the end
    std::vector<int> edge_of_side_;  // 3 a triangle
};

//! How far two triangles at an edge are bent out of one plane, radians: 0 (flat) to pi (one folded
//! onto the other). It does not depend on how the triangles are oriented. 0 if one of them has no
//! extent across the edge.
double bend_angle(const Points& points, const EdgeUse& one, const EdgeUse& other);

}  // namespace sheetmorph::mesh

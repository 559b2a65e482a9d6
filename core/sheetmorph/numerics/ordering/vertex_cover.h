// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace sheetmorph::numerics
{

//! Edges between left vertices 0 .. l - 1 and right vertices 0 .. right_count - 1.
struct BipartiteGraph
{
    std::vector<int> first = {0};  //!< (l + 1) where the edges of each left vertex begin in `right`
    std::vector<int> right;        //!< (edges) their right vertices
    int right_count = 0;

    int left_count() const { return static_cast<int>(first.size()) - 1; }
};

//! Flags of the vertices in a cover, left (l) and right (right_count).
struct VertexCover
{
    std::vector<char> left, right;
};

//! Finds the fewest vertices that touch all edges, from a largest matching (Koenig's theorem).
VertexCover smallest_vertex_cover(const BipartiteGraph& graph);

}  // namespace sheetmorph::numerics

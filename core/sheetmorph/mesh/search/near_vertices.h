// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <utility>

namespace sheetmorph::mesh
{

//! The pairs (i, j), i < j, of points at most `tolerance` apart, ascending.
//! \param tolerance  mm, >= 0; 0 finds equal points
//! \throws InvalidInput if it is negative or not finite
std::vector<std::pair<int, int>> near_pairs(const Points& points, double tolerance);

//! Clusters of vertices to merge, chained by pairs at most a tolerance apart. Vertices of two
//! pieces that only touch stay separate. A vertex at an open edge merges with any near vertex.
struct Weld
{
    std::vector<int> first;  //!< (n) by vertex: the first vertex of its cluster
    int equal = 0;           //!< vertices merged with an earlier one at exactly the same position
    int near = 0;            //!< pairs of different positions within the tolerance
};

//! \throws InvalidInput if the tolerance (mm) is negative or not finite
Weld weld(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::mesh

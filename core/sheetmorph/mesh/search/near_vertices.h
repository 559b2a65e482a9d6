// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <utility>

namespace sheetmorph::mesh
{

//! The pairs (i, j), i < j, of points no farther than `tolerance` apart, ascending.
//! \param tolerance  mm, >= 0; 0 finds the points that are equal
//! \throws InvalidInput if it is negative or not finite
std::vector<std::pair<int, int>> near_pairs(const Points& points, double tolerance);

//! Which vertices are one place, over chains of pairs no farther apart than a tolerance. Vertices
//! of two pieces that only touch stay two; those at an open edge are welded with whatever is near.
struct Weld
{
    std::vector<int>
        first;      //!< (n) the first vertex in the place of each, itself if none is before
    int equal = 0;  //!< vertices exactly where an earlier one is, and one with it
    int near = 0;   //!< pairs of different places within the tolerance
};

//! \throws InvalidInput if the tolerance (mm) is negative or not finite
Weld weld(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::mesh

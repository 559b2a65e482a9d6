// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::volume
{

//! Some rings side by side, each around a vertex; vertices are rows of what is run on.
struct RingBatch
{
    static constexpr int lanes = 8;

    int rings = 0;
    std::size_t first = 0;  //!< of its spokes
    int count = 0;  //!< of the spokes of the longest; shorter ones end with their own vertex
    int vertex[lanes] = {};
    double normal[3][lanes] = {};  //!< unit; zero if the ring has none
    double normal_weight[lanes] = {};
    double inverse[6][lanes] = {};  //!< of the moments at rest, xx yy zz xy xz yz; zero: none
};

//! From the vertex of every ring of a batch to one around it.
struct RingSpokes
{
    int other[RingBatch::lanes];
    signed char triangles[RingBatch::lanes];  //!< that have it
    signed char
        is_next[RingBatch::lanes];  //!< 1: of a triangle with the one before; 0: a chain begins
};

//! The vertices that rings count by, (n, 3).
struct RingPoints
{
    const Points& rest;
    const Points& now;
};

//! Every reference that its ring does not explain to the bit becomes what the ring tells: the polar
//! factor of the map from the ring at rest to that of now, completed by the normal.
//! \param spokes      those of all batches
//! \param references  one a ring of the batch
void turn_rings(const RingBatch& batch, const std::vector<RingSpokes>& spokes,
                const RingPoints& points, Matrix3* references);

//! Every matrix becomes its polar_rotation().
void make_rotations(std::vector<Matrix3>& matrices);

}  // namespace sheetmorph::volume

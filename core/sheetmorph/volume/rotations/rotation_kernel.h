// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::volume
{

//! Some rings side by side, each around a vertex. Vertices are rows of RingPoints.
struct RingBatch
{
    static constexpr int lanes = 8;  // from the widest register: doubles

    int rings = 0;
    std::size_t first = 0;  //!< first spoke of the batch
    int count = 0;          //!< spokes of the longest ring; others are filled with their vertex
    int vertex[lanes] = {};
    double normal[3][lanes] = {};  //!< unit; zero if the ring has none
    double normal_weight[lanes] = {};
    double inverse[6][lanes] = {};  //!< of the moments at rest: xx yy zz xy xz yz; zero if singular
};

//! Spokes: from the vertex of every ring of a batch to one neighbour.
struct RingSpokes
{
    int other[RingBatch::lanes];
    signed char triangles[RingBatch::lanes];  //!< number of triangles at the spoke
    signed char
        is_next[RingBatch::lanes];  //!< 1: same triangle as the spoke before; 0: a chain begins
};

//! The vertices that rings refer to, (n, 3).
struct RingPoints
{
    const Points& rest;
    const Points& now;
};

//! Replaces every reference that its ring does not explain to the bit by the rotation of the ring:
//! the polar factor of the map from the ring at rest to the current one, completed by the normal.
//! \param spokes      of all batches
//! \param references  one per ring of the batch
void turn_rings(const RingBatch& batch, const std::vector<RingSpokes>& spokes,
                const RingPoints& points, Matrix3* references);

//! Replaces every matrix by its polar_rotation().
void make_rotations(std::vector<Matrix3>& matrices);

}  // namespace sheetmorph::volume

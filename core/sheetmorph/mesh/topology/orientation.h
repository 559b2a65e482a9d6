// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! How the triangles of a mesh would all face one way.
struct Orientation
{
    std::vector<int> sign;     //!< (m) +1 as it is, -1 turned over; the fewer of each piece turn
    std::vector<int> flipped;  //!< the triangles with -1, ascending
    bool is_possible = true;   //!< false if a piece is one-sided (a Moebius strip)
};

//! Across every edge that two triangles share, both are made to face the same way; pieces meet in
//! nothing but edges of one or of three and more triangles. Closed pieces that face inwards as a
//! whole are not turned: signed_volume tells them.
Orientation consistent_orientation(const TriangleMesh& mesh, const EdgeTable& table);

//! The same, and every closed piece that no other one encloses faces outwards. Enclosed pieces,
//! which may be voids, face as most of their triangles do.
Orientation outward_orientation(const TriangleMesh& mesh, const EdgeTable& table);

//! The triangles as `orientation` turns them.
TriangleMesh oriented(const TriangleMesh& mesh, const Orientation& orientation);

//! The volume some triangles enclose, mm^3, as `sign` turns them: positive if they face outwards.
double signed_volume(const TriangleMesh& mesh, const std::vector<int>& triangles,
                     const std::vector<int>& sign);

}  // namespace sheetmorph::mesh

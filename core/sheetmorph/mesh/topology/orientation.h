// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! The flips that orient the triangles of a mesh consistently.
struct Orientation
{
    std::vector<int> sign;     //!< (m) +1 unchanged, -1 flipped; the minority of each piece flips
    std::vector<int> flipped;  //!< the triangles with -1, ascending
    bool is_possible = true;   //!< false if a piece is one-sided (a Moebius strip)
};

//! Orients both triangles alike at every edge that has exactly two. Pieces are separated by edges
//! with one triangle, or three and more. Closed pieces that face inwards as a whole stay inwards;
//! signed_volume() detects them.
Orientation consistent_orientation(const TriangleMesh& mesh, const EdgeTable& table);

//! The same, with every closed piece outwards that no other piece encloses. Enclosed pieces may be
//! voids; they follow the majority of their triangles.
Orientation outward_orientation(const TriangleMesh& mesh, const EdgeTable& table);

//! The triangles with the flips of `orientation` applied.
TriangleMesh oriented(const TriangleMesh& mesh, const Orientation& orientation);

//! The volume that triangles enclose with their orientation in `sign`, mm^3; positive if they face
//! outwards.
double signed_volume(const TriangleMesh& mesh, const std::vector<int>& triangles,
                     const std::vector<int>& sign);

}  // namespace sheetmorph::mesh

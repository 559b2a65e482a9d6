// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::repair
{

//! A repaired mesh, and the origin of its vertices and triangles.
struct CuredMesh
{
    mesh::TriangleMesh mesh;
    std::vector<int> vertex_of;    //!< (n) by input vertex: its index in `mesh`, -1 if removed
    std::vector<int> triangle_of;  //!< (m) by triangle of `mesh`: the input triangle it is part of
    int welded = 0;                //!< vertices merged with an earlier one
    int removed = 0;               //!< degenerate and duplicate triangles, inner walls
    int split = 0;                 //!< triangles cut at vertices inside their edges
    int turned = 0;                //!< triangles flipped to agree with their neighbours
    Convergence convergence = {};  //!< of the cuts: each may leave new vertices inside other edges
};

//! Repairs a mesh in these steps:
//! - merges vertices within `tolerance` of each other into the first; vertices of pieces that only
//!   touch, without open edges, stay apart;
//! - removes duplicate triangles and triangles lower than a thousandth of the tolerance;
//! - cuts open edges at vertices inside them (T-junctions);
//! - removes triangles lower than 1e-5 of their longest edge: it merges the ends of a short edge,
//!   or cuts the neighbour at the apex;
//! - orients every piece consistently, closed pieces outwards unless another piece encloses them;
//! - unites solids that share vertices and touch in flat walls: cuts their edges alike along the
//!   seam and removes the walls between them.
//! Edges with three or more triangles stay unchanged. Unused vertices are removed.
//! \param tolerance    mm, >= 0
//! \param most_rounds  of cuts
//! \throws InvalidInput if the tolerance is negative or not finite, or if no triangle would remain
CuredMesh cured(const mesh::TriangleMesh& mesh, double tolerance, int most_rounds = 8);

}  // namespace sheetmorph::repair

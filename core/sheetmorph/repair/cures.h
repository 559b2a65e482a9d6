// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::repair
{

//! A mesh after its cures, and where everything in it came from.
struct CuredMesh
{
    mesh::TriangleMesh mesh;
    std::vector<int> vertex_of;    //!< (n) of every vertex given: its place in `mesh`, -1 if gone
    std::vector<int> triangle_of;  //!< (m) of every triangle of `mesh`: the one given it is part of
    int welded = 0;                //!< vertices that became one with an earlier one
    int removed = 0;               //!< triangles that stood twice or had no height, inner walls
    int split = 0;                 //!< triangles cut at vertices inside their edges
    int turned = 0;                //!< triangles turned to face as their neighbours do
    Convergence convergence = {};  //!< of the cuts: each may leave new ends inside other edges
};

//! Welds vertices nearer than a tolerance to the place of the first of them (those of pieces that
//! only touch, without open edges, stay apart), removes triangles
//! without height (lower than a thousandth of it) and doubled ones, cuts open edges at the vertices
//! inside them (T-junctions), takes out triangles that are lower than 1e-5 of their longest edge
//! (what is beside one is cut at its corner; the ends of an edge that short become one), and makes
//! each piece face one way: outwards where it is closed, unless another piece encloses it. Solids
//! that have vertices in common and lie against each other in flat walls become one: their edges
//! are cut alike along the seam, and the walls between them go. Edges with three triangles or more
//! stay as they are; vertices in no triangle go. \param tolerance    mm, >= 0 \param most_rounds of
//! cuts \throws InvalidInput if the tolerance is negative or not finite, or no triangle would be
//! left
CuredMesh cured(const mesh::TriangleMesh& mesh, double tolerance, int most_rounds = 8);

}  // namespace sheetmorph::repair

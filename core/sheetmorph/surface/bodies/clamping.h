// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! (n) marks the vertices of fixed, handle and propagated regions, also where a carried feature
//! owns them.
std::vector<char> holding_vertices(const SurfaceConstraints& constraints, const VertexRoles& roles);

//! Assigns the role `clamped` to the free neighbours of fixed, handle and propagated vertices. A
//! clamped vertex moves rigidly with the nearest of these. Where several regions meet, it takes the
//! mean of their motions, so that the result does not depend on their order. Vertices of features
//! and tied vertices keep their roles. Point constraints never clamp.
//! \param neighbours  (n, n): an entry wherever two vertices share an edge of the sheet
void clamp_neighbours(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                      const numerics::SparseMatrix& neighbours, VertexRoles& roles);

//! Fills in the rotations of clamped vertices from those of their carriers.
void turn_clamped(const VertexRoles& roles, KnownRotations& rotations);

//! Fills in the displacements of clamped vertices (n, 3) from those of their carriers, which must
//! be set.
void place_clamped(const PlacementInput& part, const GivenRotations& given,
                   Eigen::MatrixXd& displacements);

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! (n) vertices of fixed, handle and propagated regions, also where a feature that they carry has
//! taken them over.
std::vector<char> holding_vertices(const SurfaceConstraints& constraints, const VertexRoles& roles);

//! Gives the free neighbours of fixed, handle and propagated vertices the role `clamped`: they move
//! rigidly with the nearest of them, and where several regions meet as the mean of what each asks
//! for, so that no order of regions counts. Vertices of features keep their feature, tied ones
//! their sheet; points of triangles never clamp.
//! \param neighbours  (n, n): an entry wherever two vertices share an edge of the sheet
void clamp_neighbours(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                      const numerics::SparseMatrix& neighbours, VertexRoles& roles);

//! Fills the rows of clamped vertices: the rotations of their carriers.
void turn_clamped(const VertexRoles& roles, KnownRotations& rotations);

//! Fills the rows of clamped vertices in the displacements (n, 3), whose carriers are known.
void place_clamped(const PlacementInput& part, const GivenRotations& given,
                   Eigen::MatrixXd& displacements);

}  // namespace sheetmorph::surface

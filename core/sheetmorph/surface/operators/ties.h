// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/constraints/constraints.h"

namespace sheetmorph::surface
{

//! C (n, n) of u = C u: replaces tied vertices by the corners to which they are attached,
//! recursively. Columns of tied vertices are empty; other vertices are unchanged.
numerics::SparseMatrix tie_basis(Eigen::Index vertex_count, const std::vector<Tie>& ties);

//! Fills the rows (n, k) of tied vertices from the rows of their corners.
void fill_tied(const std::vector<Tie>& ties, Eigen::MatrixXd& rows);
void fill_tied(const std::vector<Tie>& ties, Points& rows);

//! Ties between borders that coincide vertex by vertex: the two sheets are one there.
std::vector<Tie> glued_ties(const mesh::TriangleMesh& mesh, const std::vector<Tie>& ties);

//! The mesh in which triangles use the anchor vertices instead of tied vertices.
mesh::TriangleMesh glued(const mesh::TriangleMesh& mesh, const std::vector<Tie>& ties);

}  // namespace sheetmorph::surface

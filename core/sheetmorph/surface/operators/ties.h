// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/constraints/constraints.h"

namespace sheetmorph::surface
{

//! C (n, n) of u = C u: tied vertices by the corners that they stand on, or those by theirs; all
//! others by themselves. The columns of tied ones are empty.
numerics::SparseMatrix tie_basis(Eigen::Index vertex_count, const std::vector<Tie>& ties);

//! The rows (n, k) of tied vertices, from those of the corners that they stand on.
void fill_tied(const std::vector<Tie>& ties, Eigen::MatrixXd& rows);
void fill_tied(const std::vector<Tie>& ties, Points& rows);

//! Ties of borders that lie on each other, vertex on vertex: the two sheets are one there.
std::vector<Tie> glued_ties(const mesh::TriangleMesh& mesh, const std::vector<Tie>& ties);

//! The mesh with the triangles of tied vertices on what they stand on.
mesh::TriangleMesh glued(const mesh::TriangleMesh& mesh, const std::vector<Tie>& ties);

}  // namespace sheetmorph::surface

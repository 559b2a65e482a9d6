// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/geometry/laid_faces.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

namespace sheetmorph::surface
{

//! Rows of a bending energy sum_r w_r |(D p)_r - R_at(r) (D p_hat)_r|^2.
struct BendingRows
{
    numerics::SparseMatrix rows;  //!< D (r, n)
    Eigen::VectorXd weights;      //!< w (r)
    VertexIds row_vertices;       //!< (r) the vertex whose rotation turns the rest row
};

//! The rows of `natural`, whose only null functions on a flat free sheet are the affine ones:
//! - at every interior vertex i, weight M_i, the 9 entries (a, b) of a Hessian,
//!   1/M_i sum_f A_f (grad u)_f,a (grad phi_i)_f,b, gradients in 3D (Stein, Grinspun, Wardetzky,
//!   Jacobson 2018). M_i is the mixed Voronoi area, as in L: with a third of the areas around i,
//!   a cantilever graded 1 : 7 stalls at an error of 5e-3 where this one halves it every time;
//! - at every interior edge of a face that touches a free boundary, weight 1/4 * 3 / (A_1 + A_2),
//! the
//!   hinge row (c03 + c04, c01 + c02, -c01 - c03, -c02 - c04) (Bergou et al. 2006), half of it
//!   turned by each end of the edge. Where k faces meet on an edge, every pair has one, times 2/k.
//! - where sheets touch in one vertex only, what the mean gradient around it in each sheet differs
//!   from the mean of all, so that the vertex is no ball joint.
//! \param is_held  (n) vertices of known regions: where they are the boundary, it is not free.
//!                 Vertices of no face have empty columns
BendingRows natural_rows(const mesh::LaidFaces& faces, const std::vector<char>& is_held);

}  // namespace sheetmorph::surface

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
    VertexIds row_vertices;       //!< (r) the vertex whose rotation applies to the rest row
};

//! The rows of `natural`. Their only null functions on a flat free sheet are the affine ones:
//! - At every interior vertex i, with weight M_i, the 9 entries (a, b) of a Hessian, 1/M_i sum_f
//!   A_f (grad u)_f,a (grad phi_i)_f,b, with gradients in 3D (Stein, Grinspun, Wardetzky, Jacobson
//!   2018). M_i is the mixed Voronoi area, as in L. With a third of the areas around i instead, a
//!   cantilever graded 1 : 7 stalls at an error of 5e-3; with M_i each refinement halves the error.
//! - At every interior edge of a face that touches a free boundary, with weight 1/4 * 3 / (A_1 +
//!   A_2), the hinge row (c03 + c04, c01 + c02, -c01 - c03, -c02 - c04) (Bergou et al. 2006). Each
//!   end of the edge rotates half of it. Where k faces meet at an edge, every pair has a row with
//!   weight 2/k.
//! - Where sheets touch in a single vertex, the deviation of each sheet's mean gradient from the
//!   mean of all sheets, so that the vertex does not act as a ball joint.
//! \param is_held  (n) vertices of prescribed regions; the boundary is not free there. Unused
//!                 vertices have empty columns
BendingRows natural_rows(const mesh::LaidFaces& faces, const std::vector<char>& is_held);

}  // namespace sheetmorph::surface

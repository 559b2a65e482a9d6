// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/bodies/vertex_roles.h"

namespace sheetmorph::surface
{

//! The rest shape as the energies see it: sum_r w_r |(D p)_r - R_at(r) (D p_hat)_r|^2 (2.2).
struct SurfaceOperators
{
    numerics::SparseMatrix rows;   //!< D (r, n): L of (2.1) for `paper` and `neumann`, 1/mm
    Eigen::VectorXd weights;       //!< w (r): A_i mm^2, or 1 for `paper`
    Points rest_rows;              //!< D p_hat (r, 3): delta of (2.1), 1/mm
    VertexIds row_vertices;        //!< (r) the vertex whose rotation turns the rest row
    Points half_cotangents;        //!< (m, 3)
    Eigen::VectorXd vertex_areas;  //!< A (n) mm^2

    Convergence convergence = {};  //!< of the intrinsic triangles they are measured on

    //! (n, n) stiffness of the rotation field: edge weights >= 0
    std::shared_ptr<const numerics::SparseMatrix> harmonic;

    std::shared_ptr<const numerics::SparseMatrix> stiffness;  //!< D^T diag(w) D (n, n)

    //! In which order the vertices are eliminated, whatever is known of them: of the stiffness, and
    //! of the harmonic one, whose separators are half as wide.
    std::shared_ptr<const numerics::SeparatorTree> tree, harmonic_tree;
};

//! (r, 3) what the rest rows gain where they turn: (R - I) D p_hat.
//! \param change  (n) R - I at every vertex
Points turned_rows(const SurfaceOperators& operators, const std::vector<Matrix3>& change);

//! \param roles  a component that only points hold can tilt under `natural`; unless three or more
//!               that are not in line hold it, its free edges have the rows of `neumann` too
SurfaceOperators surface_operators(const mesh::TriangleMesh& mesh,
                                   const SurfaceConstraints& constraints, const VertexRoles& roles);

}  // namespace sheetmorph::surface

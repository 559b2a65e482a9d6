// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/bodies/vertex_roles.h"

namespace sheetmorph::surface
{

//! Discrete operators of the rest shape for the energies sum_r w_r |(D p)_r - R_at(r) (D
//! p_hat)_r|^2 (2.2).
struct SurfaceOperators
{
    numerics::SparseMatrix rows;   //!< D (r, n): L of (2.1) for `paper` and `neumann`, 1/mm
    Eigen::VectorXd weights;       //!< w (r): A_i mm^2, or 1 for `paper`
    Points rest_rows;              //!< D p_hat (r, 3): delta of (2.1), 1/mm
    VertexIds row_vertices;        //!< (r) the vertex whose rotation applies to the rest row
    Points half_cotangents;        //!< (m, 3)
    Eigen::VectorXd vertex_areas;  //!< A (n) mm^2

    Convergence convergence = {};  //!< of the intrinsic triangulation

    //! (n, n) stiffness of the rotation field: edge weights >= 0.
    std::shared_ptr<const numerics::SparseMatrix> harmonic;

    std::shared_ptr<const numerics::SparseMatrix> stiffness;  //!< D^T diag(w) D (n, n)

    //! Elimination orders of all vertices, for any constraints: of `stiffness` and of `harmonic`,
    //! whose separators are half as wide.
    std::shared_ptr<const numerics::SeparatorTree> tree, harmonic_tree;
};

//! (r, 3) change of the rest rows under rotations: (R - I) D p_hat.
//! \param change  (n) R - I at every vertex
Points turned_rows(const SurfaceOperators& operators, const std::vector<Matrix3>& change);

//! Assembles the operators of a part.
//! \param roles  a component supported only by points can tilt under `natural`. Its free edges also
//!               get the rows of `neumann`, unless three or more points that are not collinear
//!               support it
SurfaceOperators surface_operators(const mesh::TriangleMesh& mesh,
                                   const SurfaceConstraints& constraints, const VertexRoles& roles);

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/numerics/sparse_cholesky.h"
#include "sheetmorph/surface/constraints.h"

namespace sheetmorph
{

//! The rest shape as the energies see it.
struct SurfaceOperators
{
    Points half_cotangents;        //!< (m, 3)
    SparseMatrix laplacian;        //!< L (n, n) of (2.1), 1/mm
    Eigen::VectorXd weights;       //!< (n) of the rows of the energy: A_i mm^2, or 1 for `paper`
    Points curvature_normals;      //!< delta (n, 3) of the rest shape, 1/mm
    Eigen::VectorXd vertex_areas;  //!< A (n) mm^2
};

SurfaceOperators surface_operators(const TriangleMesh& mesh, Energy energy);

}  // namespace sheetmorph

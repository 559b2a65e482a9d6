// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"

namespace sheetmorph::surface
{

//! Rows s_l p_i + t_l p_j + u_l p_k of (2.3), (k, n), for the `chosen` points in that order.
numerics::SparseMatrix point_rows(const mesh::TriangleMesh& mesh,
                                  const std::vector<PointConstraint>& points,
                                  const std::vector<int>& chosen);

//! (k, 3) displacement of each point from rest to its target, mm.
Eigen::MatrixXd point_displacements(const mesh::TriangleMesh& mesh,
                                    const std::vector<PointConstraint>& points,
                                    const std::vector<PointTarget>& targets);

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

#include <Eigen/SparseCore>

namespace sheetmorph::numerics
{

//! Z^T Z (k, k) for Z = L^-1 right, lower triangle; undefined above it. Every front processes only
//! the columns that reach it, so sparse columns are cheap.
//! \param right  (slots, k)
Weights half_solved_product(const FrontList& factor,
                            const Eigen::SparseMatrix<double, Eigen::RowMajor>& right);

}  // namespace sheetmorph::numerics

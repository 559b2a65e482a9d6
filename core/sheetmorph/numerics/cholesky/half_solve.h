// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

#include <Eigen/SparseCore>

namespace sheetmorph::numerics
{

//! Z^T Z (k, k) of Z = L^-1 right, its lower triangle; above it the result is undefined. Every
//! front is only met by the columns that reach it, so that sparse columns take little.
//! \param right  (slots, k)
Weights half_solved_product(const FrontList& factor,
                            const Eigen::SparseMatrix<double, Eigen::RowMajor>& right);

}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"

namespace sheetmorph::numerics
{

//! Fronts of a pattern without values.
//! \param earlier  optional, a factor of the earlier pattern: unchanged fronts are shared, values
//!     included
FrontList new_fronts(const FrontPattern& pattern, const FrontList* earlier = nullptr);

//! Computes the values of all fronts that the earlier factor does not share, by the multifrontal
//! method. Subtrees run in parallel.
//! \param values  a matrix of the pattern
//! \throws SolverError if the matrix is not positive definite; the values are then undefined
void factorise_fronts(const FrontPattern& pattern, const SparseMatrix& values, FrontList& factor);

}  // namespace sheetmorph::numerics

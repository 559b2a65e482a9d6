// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front.h"
#include "sheetmorph/numerics/elimination.h"

namespace sheetmorph
{

//! A factor made before, and where it eliminated what.
struct EarlierFactor
{
    const Elimination& elimination;
    const FrontList& fronts;
};

//! Cholesky factor of a merged matrix by the multifrontal method, a front for every node of its
//! tree, subtrees at the same time.
//! \param earlier  of the same whole matrix and tree: fronts that are still right are shared
//! \throws SolverError if the matrix is not positive definite
FrontList frontal_cholesky(const Elimination& elimination, const EarlierFactor* earlier = nullptr);

}  // namespace sheetmorph

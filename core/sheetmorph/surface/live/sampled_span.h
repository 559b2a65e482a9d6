// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <vector>

namespace sheetmorph
{

//! What many columns have in common: a few of them, and directions that blend to all of them.
struct SampledSpan
{
    std::vector<Eigen::Index> chosen;  //!< (k) columns, each the one most missed so far
    Eigen::MatrixXd directions;        //!< Q (e, k), orthonormal
    Eigen::MatrixXd upper;             //!< (k, k) upper triangle: the chosen ones are Q upper
    Eigen::VectorXd reach;             //!< (k) the largest number that any column has in Q
};

//! \param columns  (e, m)
//! \returns        a span that misses no entry of any column by more than 1e-8
SampledSpan spanned(Eigen::MatrixXd columns);

}  // namespace sheetmorph

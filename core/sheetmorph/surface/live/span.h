// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <vector>

namespace sheetmorph::surface
{

//! A reduced basis of many columns (snapshots), selected greedily.
struct Span
{
    std::vector<Eigen::Index> chosen;  //!< (k) selected columns, in order
    Eigen::MatrixXd directions;        //!< Q (e, k), orthonormal
    Eigen::MatrixXd upper;             //!< (k, k) upper triangle R: the selected columns are Q R
    Eigen::VectorXd reach;             //!< (k) largest coefficient of any column in Q
    double miss = 0.0;                 //!< largest error of an entry of any column
};

//! \param columns  (e, m), three per pose; columns of fewer poses are preferred
//! \returns        a span with errors up to 2e-8, or with the maximum of 600 directions
Span spanned(Eigen::MatrixXd columns);

//! Interpolation points of a reduced basis Q (e, k): about 2 k rows, ascending. Combinations of Q
//! that agree there agree everywhere (empirical interpolation; pivoted QR of Q^T, applied a second
//! time to the remaining rows).
std::vector<Eigen::Index> telling_rows(const Eigen::MatrixXd& directions);

}  // namespace sheetmorph::surface

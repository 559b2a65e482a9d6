// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <vector>

namespace sheetmorph::surface
{

//! What many columns have in common: a few of them, and directions that blend to all of them.
struct Span
{
    std::vector<Eigen::Index> chosen;  //!< (k) columns, each among the most missed so far
    Eigen::MatrixXd directions;        //!< Q (e, k), orthonormal
    Eigen::MatrixXd upper;             //!< (k, k) upper triangle: the chosen ones are Q upper
    Eigen::VectorXd reach;             //!< (k) the largest number that any column has in Q
    double miss = 0.0;                 //!< by which an entry of a column is missed at most
};

//! \param columns  (e, m), three a pose: how many poses are chosen matters too
//! \returns        a span that misses no entry of any column by more than 2e-8, or one of 600
//!                 directions
Span spanned(Eigen::MatrixXd columns);

//! Rows of Q (e, k), ascending, about twice k, from which numbers in Q are told best: blends of Q
//! that agree there agree everywhere (empirical interpolation; pivoted QR of Q^T, then of what the
//! rows found leave).
std::vector<Eigen::Index> telling_rows(const Eigen::MatrixXd& directions);

}  // namespace sheetmorph::surface

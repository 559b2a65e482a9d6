// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/operators/unknowns.h"

namespace sheetmorph
{

//! Weights of groups, the weights of one vertex side by side.
using WeightsByVertex = Eigen::SparseMatrix<double, Eigen::RowMajor>;

//! A sheet with some groups of vertices; the other vertices are unknown, or belong to no group and
//! have no weight.
struct WeightedSheet
{
    const SparseMatrix& harmonic;  //!< K (n, n)
    const Unknowns& unknowns;
    const SparseCholesky& factor;  //!< of K merged by the unknowns
};

//! How a harmonic weight counts.
struct WeightCount
{
    double faded = 0.0;    //!< a weight of so much counts as 0, and 1 still as 1
    double least = 0.0;    //!< smaller weights are not stored
    bool has_rest = true;  //!< what the weights lack of 1 belongs to somebody else, and counts too
};

//! Harmonic weights w of groups, 1 on the group and 0 on all others, each passed through
//! 3 w^2 - 2 w^3 and divided by their sum. Time and memory grow with the weights that are stored: a
//! vertex among many groups sees those around it.
//! \param groups  vertices of no other group
//! \returns       (n, groups), rows within [0, 1] with the sum 1, at most 1 where there is a rest
SparseMatrix smooth_weights(const WeightedSheet& sheet, const std::vector<VertexIds>& groups,
                            const WeightCount& count);

//! (unknowns, count): what groups of value 1 pull on the unknowns around them.
Eigen::MatrixXd pull_of(const WeightedSheet& sheet, const VertexIds* groups, Eigen::Index count);

//! (n, 3) weights * values. \param values  (groups, 3)
Points weighted(const WeightsByVertex& weights, const Points& values);

}  // namespace sheetmorph

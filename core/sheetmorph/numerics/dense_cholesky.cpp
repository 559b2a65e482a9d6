// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/dense_cholesky.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace sheetmorph
{

namespace
{

// Rows of a block: the triangular work inside blocks is slow, the products between them are fast.
constexpr Eigen::Index block = 48;

// columns first .. of `rows`, once the columns before them are subtracted, times (L_jj)^-T.
void finish_columns(const Weights& inverse_blocks, Eigen::Index first, WeightsTarget rows)
{
    const Eigen::Index wide = std::min(block, inverse_blocks.rows() - first);
    const Weights right = rows.middleCols(first, wide);
    rows.middleCols(first, wide).setZero();
    add_product(right, inverse_blocks.block(first, 0, wide, wide), 1.0,
                rows.middleCols(first, wide));
}

}  // namespace

DenseCholesky::DenseCholesky(Weights matrix)
    : lower_(std::move(matrix)), inverse_blocks_(Weights::Zero(lower_.rows(), block))
{
    const Eigen::Index size = lower_.rows();
    for (Eigen::Index j = 0; j < size; j += block)
    {
        const Eigen::Index wide = std::min(block, size - j), below = size - j - wide;
        const Eigen::LLT<Eigen::MatrixXd> factor(lower_.block(j, j, wide, wide));
        if (factor.info() != Eigen::Success)
            throw SolverError("a dense matrix is not positive definite");
        const Eigen::MatrixXd diagonal = factor.matrixL();
        lower_.block(j, j, wide, wide) = diagonal;
        inverse_blocks_.block(j, 0, wide, wide) =
            diagonal.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(wide, wide));
        finish_columns(inverse_blocks_, j, lower_.bottomRows(below));
        const auto column = lower_.block(j + wide, j, below, wide);
        add_lower_product(column, column, -1.0, lower_.bottomRightCorner(below, below));
    }
}

Points DenseCholesky::solve(const Points& right) const
{
    return solve_upper(lower_.triangularView<Eigen::Lower>().solve(right));
}

Points DenseCholesky::solve_upper(const Points& right) const
{
    return lower_.triangularView<Eigen::Lower>().transpose().solve(right);
}

Weights DenseCholesky::half_solve_rows(Weights rows) const
{
    for (Eigen::Index j = 0; j < lower_.rows(); j += block)
    {
        const Eigen::Index wide = std::min(block, lower_.rows() - j);
        add_product(rows.leftCols(j), lower_.block(j, 0, wide, j), -1.0, rows.middleCols(j, wide));
        finish_columns(inverse_blocks_, j, rows);
    }
    return rows;
}

}  // namespace sheetmorph

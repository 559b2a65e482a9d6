// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace sheetmorph::numerics
{
namespace
{

// The upper triangle of what the kernel writes is not defined.
double worst_below(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return Eigen::MatrixXd(Eigen::MatrixXd(a - b).triangularView<Eigen::Lower>())
        .cwiseAbs()
        .maxCoeff();
}

// From one row to so many that threads share them.
TEST(DenseCholesky, SubtractsTheProductOfRowsWithThemselves)
{
    for (const int rows : {1, 7, 64, 401})
        for (const int columns : {1, 30, 67})
        {
            const Weights own = Weights::Random(rows, columns);
            Weights result = Weights::Random(rows, rows);
            const Eigen::MatrixXd expected = result - own * own.transpose();
            subtract_own_product(own, result);
            EXPECT_LT(worst_below(result, expected), 1e-12) << rows << " " << columns;
        }
}

TEST(DenseCholesky, FactorisesThePartOfAMatrixThatIsBelowItsColumns)
{
    for (const int columns : {1, 16, 47, 130})
        for (const int below : {0, 3, 300})
        {
            const int rows = columns + below;
            const Eigen::MatrixXd some = Eigen::MatrixXd::Random(rows, rows);
            const Eigen::MatrixXd whole =
                some * some.transpose() + rows * Eigen::MatrixXd::Identity(rows, rows);
            const Eigen::MatrixXd expected = whole.llt().matrixL();
            Weights panel = whole.leftCols(columns), inverse_blocks;
            factorise_columns(panel, inverse_blocks);
            for (int column = 0; column < columns; ++column)
                EXPECT_LT((panel.col(column) - expected.col(column))
                              .bottomRows(rows - column)
                              .cwiseAbs()
                              .maxCoeff(),
                          1e-10)
                    << columns << " " << below;
        }
}

}  // namespace
}  // namespace sheetmorph::numerics

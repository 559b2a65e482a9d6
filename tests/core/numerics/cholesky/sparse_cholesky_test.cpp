// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "numerics/cholesky/cholmod_oracle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sheetmorph
{
namespace
{

// Second differences on n points: positive definite, inverse known in closed form.
SparseMatrix second_differences(int n, double shift = 0.0)
{
    SparseMatrix matrix(n, n);
    for (int i = 0; i < n; ++i)
    {
        matrix.insert(i, i) = 2.0 - shift;
        if (i > 0)
        {
            matrix.insert(i, i - 1) = -1.0;
            matrix.insert(i - 1, i) = -1.0;
        }
    }
    return matrix;
}

// On a line: the order of elimination comes from where the points lie.
SparseCholesky factor_of(const SparseMatrix& matrix)
{
    Points places = Points::Zero(matrix.rows(), 3);
    for (int i = 0; i < matrix.rows(); ++i)
        places(i, 0) = i;
    return SparseCholesky(all_of(matrix),
                          std::make_shared<const SeparatorTree>(nested_dissection(matrix, places)));
}

TEST(SparseCholesky, SolvesForSeveralRightSidesAtOnce)
{
    const int n = 200;
    const SparseMatrix matrix = second_differences(n);
    const SparseCholesky factor = factor_of(matrix);
    const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(n, 5);
    EXPECT_LT((factor.solve(matrix * expected) - expected).norm(), 1e-9);
    EXPECT_GE(factor.factor_entries(), 2 * n - 1);
}

TEST(SparseCholesky, AgreesWithAnotherLibrary)
{
    const SparseMatrix matrix = second_differences(500, -0.1);
    const Eigen::MatrixXd right_sides = Eigen::MatrixXd::Random(500, 3);
    const Eigen::MatrixXd expected = CholmodOracle(matrix).solve(right_sides);
    EXPECT_LT((factor_of(matrix).solve(right_sides) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SparseCholesky, SolvesThePoissonProblemOnALineExactly)
{
    const int n = 9;
    const Eigen::MatrixXd x = factor_of(second_differences(n)).solve(Eigen::VectorXd::Ones(n));
    for (int i = 0; i < n; ++i)
        EXPECT_NEAR(x(i, 0), 0.5 * (i + 1) * (n - i), 1e-12);
}

// A few sparse columns meet few of the fronts, full ones all of them; both by groups that do not
// end with them.
TEST(SparseCholesky, ProductsOfSolvedColumnsAreThoseOfTheColumnsSolved)
{
    const int n = 3000;
    const SparseMatrix matrix = second_differences(n, -0.01);
    const SparseCholesky factor = factor_of(matrix);
    for (const bool is_full : {false, true})
    {
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 11);
        for (int column = 0; column < right.cols(); ++column)
            for (int row = is_full ? 0 : 250 * column; row < (is_full ? n : 250 * column + 9);
                 ++row)
                right(row, column) = std::sin(1.0 + row * (column + 1));
        const Eigen::MatrixXd expected = right.transpose() * factor.solve(right);
        const Eigen::MatrixXd found = factor.solved_product(right.sparseView());
        EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff());
    }
    EXPECT_EQ(factor.solved_product(SparseMatrix(n, 2)), Weights::Zero(2, 2));
    EXPECT_EQ(factor.solved_product(SparseMatrix(n, 0)).size(), 0);
}

TEST(SparseCholesky, RefusesAMatrixThatIsNotPositiveDefinite)
{
    EXPECT_THROW(factor_of(second_differences(20, 3.0)), SolverError);
    EXPECT_THROW(factor_of(SparseMatrix(4, 4)), SolverError);
}

TEST(SparseCholesky, AcceptsASystemWithoutUnknowns)
{
    const SparseCholesky factor = factor_of(SparseMatrix(0, 0));
    EXPECT_EQ(factor.solve(Eigen::MatrixXd(0, 3)).cols(), 3);
}

}  // namespace
}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"

#include <gtest/gtest.h>

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

TEST(SparseCholesky, SolvesForSeveralRightSidesAtOnce)
{
    const int n = 200;
    const SparseMatrix matrix = second_differences(n);
    const SparseCholesky factor(matrix);
    const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(n, 5);
    EXPECT_LT((factor.solve(matrix * expected) - expected).norm(), 1e-9);
    EXPECT_GE(factor.factor_entries(), 2 * n - 1);
}

TEST(SparseCholesky, SolvesThePoissonProblemOnALineExactly)
{
    const int n = 9;
    const Eigen::MatrixXd x = SparseCholesky(second_differences(n)).solve(Eigen::VectorXd::Ones(n));
    for (int i = 0; i < n; ++i)
        EXPECT_NEAR(x(i, 0), 0.5 * (i + 1) * (n - i), 1e-12);
}

TEST(SparseCholesky, RefusesAMatrixThatIsNotPositiveDefinite)
{
    EXPECT_THROW(SparseCholesky(second_differences(20, 3.0)), SolverError);
    EXPECT_THROW(SparseCholesky(SparseMatrix(4, 4)), SolverError);
}

TEST(SparseCholesky, AcceptsASystemWithoutUnknowns)
{
    const SparseCholesky factor{SparseMatrix(0, 0)};
    EXPECT_EQ(factor.solve(Eigen::MatrixXd(0, 3)).cols(), 3);
}

}  // namespace
}  // namespace sheetmorph

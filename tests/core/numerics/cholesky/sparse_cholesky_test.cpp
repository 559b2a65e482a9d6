// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "numerics/cholesky/cholmod_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sheetmorph::numerics
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

// Beyond 5e5 entries threads share the subtrees of a factor. A bilaplacian of a grid with drawn
// stiffnesses, and one on a line of blocks, whose tree is not balanced.
SparseMatrix drawn_bilaplacian(int wide, int high, unsigned seed)
{
    std::mt19937 bits(seed);
    std::uniform_real_distribution<double> stiffness(0.1, 10.0);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < wide * high; ++i)
        for (const int other : {i % wide + 1 < wide ? i + 1 : i, i + wide})
            if (other != i && other < wide * high)
            {
                const double drawn = stiffness(bits);
                for (const auto& [a, b] : {std::pair(i, other), std::pair(other, i)})
                {
                    entries.emplace_back(a, b, -drawn);
                    entries.emplace_back(a, a, drawn);
                }
            }
    for (int i = 0; i < wide * high; i += 7)
        entries.emplace_back(i, i, 0.5);
    SparseMatrix laplacian(wide * high, wide * high);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    return laplacian * laplacian;
}

class LargeFactors : public testing::TestWithParam<std::pair<int, int>>
{
};

TEST_P(LargeFactors, AgreeWithAnotherLibraryForAnyNumberOfRightSidesAndThreads)
{
    const auto [wide, high] = GetParam();
    const SparseMatrix matrix = drawn_bilaplacian(wide, high, 5);
    Points places = Points::Zero(matrix.rows(), 3);
    for (int i = 0; i < matrix.rows(); ++i)
        places.row(i) << i % wide, i / wide, 0.0;
    const SparseCholesky factor(
        all_of(matrix), std::make_shared<const SeparatorTree>(nested_dissection(matrix, places)));
    ASSERT_GT(factor.factor_entries(), 5e5);
    CholmodOracle oracle(matrix);
    for (const int sides : {1, 2, 3, 4, 5, 9, 24, 50})
    {
        const Eigen::MatrixXd right = Eigen::MatrixXd::Random(matrix.rows(), sides);
        const Eigen::MatrixXd found = factor.solve(right), expected = oracle.solve(right);
        EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm()) << sides;
        EXPECT_LT((matrix * found - right).norm(), 1e-10 * right.norm()) << sides;
        for (const int threads : {1, 3, 8})
        {
            const ThreadCount some(threads);
            EXPECT_TRUE((factor.solve(right).array() == found.array()).all())
                << sides << " right sides, " << threads << " threads";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, LargeFactors,
                         testing::Values(std::pair(110, 110), std::pair(1600, 12),
                                         std::pair(40, 301)));

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
}  // namespace sheetmorph::numerics

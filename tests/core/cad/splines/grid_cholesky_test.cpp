// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/grid_cholesky.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::cad::test
{

namespace
{

constexpr int reach = GridMatrix::reach, across = GridMatrix::across;

// A positive definite matrix of a grid, dense.
struct Case
{
    GridMatrix sparse;
    Eigen::MatrixXd dense;

    Case(int rows, int columns, std::array<bool, 2> is_tied)
        : sparse{rows, columns, {}, {}, is_tied}
    {
        const int count = rows * columns;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> value(-1.0, 1.0);
        dense = Eigen::MatrixXd::Identity(count, count) * 40.0;
        sparse.products.assign(static_cast<std::size_t>(count) * across * across, 0.0);
        for (int a = 0; a < count; ++a)
            for (int b = 0; b < a; ++b)
                if (std::abs(a / columns - b / columns) <= reach
                    && std::abs(a % columns - b % columns) <= reach)
                    dense(a, b) = dense(b, a) = value(random);
        for (int a = 0; a < count; ++a)
            for (int b = 0; b < count; ++b)
                if (const int k = b / columns - a / columns, l = b % columns - a % columns;
                    std::abs(k) <= reach && std::abs(l) <= reach)
                    sparse.products[static_cast<std::size_t>((a * across + k + reach) * across + l
                                                             + reach)] = dense(a, b);
        if (is_tied[0])
            tie((rows - 2) * columns + 1, columns);
        if (is_tied[1])
            tie(2 * columns + columns - 1, 2 * columns);
    }

    void tie(int row, int column)
    {
        sparse.ties.emplace_back(row, column, 3.0);
        dense(row, column) += 3.0;
        dense(column, row) += 3.0;
    }
};

}  // namespace

TEST(GridCholesky, SolvesAsADenseMatrixDoes)
{
    for (const auto& [rows, columns] : {std::pair(4, 4), {9, 31}, {30, 8}, {23, 27}})
        for (const std::array<bool, 2> is_tied :
             {std::array{false, false}, {true, false}, {false, true}, {true, true}})
        {
            const Case one(rows, columns, is_tied);
            const Eigen::MatrixXd right = Eigen::MatrixXd::Random(rows * columns, 3);
            const GridCholesky factors(one.sparse, 0.5);
            ASSERT_TRUE(factors.is_definite());
            Eigen::MatrixXd shifted = one.dense;
            shifted.diagonal().array() += 0.5;
            const Eigen::MatrixXd expected = shifted.ldlt().solve(right);
            EXPECT_LT((factors.solve(right) - expected).cwiseAbs().maxCoeff(), 1e-12)
                << rows << " x " << columns;
            EXPECT_LT((one.sparse.times(right) - one.dense * right).cwiseAbs().maxCoeff(), 1e-12);
            EXPECT_EQ(one.sparse.largest(), 40.0);
        }
}

TEST(GridCholesky, TellsThatAMatrixIsNotDefinite)
{
    Case one(20, 20, {false, false});
    one.sparse.products[static_cast<std::size_t>((210 * across + reach) * across + reach)] = -1.0;
    EXPECT_FALSE(GridCholesky(one.sparse, 0.0).is_definite());
    EXPECT_TRUE(GridCholesky(one.sparse, 60.0).is_definite());
}

}  // namespace sheetmorph::cad::test

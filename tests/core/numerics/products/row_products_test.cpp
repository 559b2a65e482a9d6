// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/row_products.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::numerics
{

namespace
{

class RowProductsTest : public testing::Test
{
protected:
    SparseMatrix sparse(Eigen::Index rows, Eigen::Index columns)
    {
        SparseMatrix matrix(rows, columns);
        std::vector<Eigen::Triplet<double>> entries;
        for (int column = 0; column < columns; ++column)
            for (int k = 0; k < 4; ++k)
                entries.emplace_back(static_cast<int>(random_() % rows), column, number());
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    Eigen::MatrixXd dense(Eigen::Index rows, Eigen::Index columns)
    {
        return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return number(); });
    }

    double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

    // Every third row of none, neighbours share one.
    static SparseMatrix basis(int rows)
    {
        SparseMatrix matrix(rows, rows / 6 + 1);
        for (int row = 0; row < rows; ++row)
            if (row % 3 != 0)
                matrix.insert(row, row / 6) = 1.0;
        return matrix;
    }

    std::mt19937 random_{3};
};

TEST_F(RowProductsTest, AnyNumberOfColumnsIsMultipliedAsDenseMatricesAre)
{
    for (const int columns : {1, 3, 4, 7})
    {
        const SparseMatrix rows = sparse(50, 40);
        const Eigen::VectorXd weights = dense(50, 1);
        const Eigen::MatrixXd f = dense(50, columns), u = dense(40, columns);
        RowProducts products(rows, weights);
        const Eigen::MatrixXd left = f - Eigen::MatrixXd(rows) * u;
        const Eigen::MatrixXd pull =
            Eigen::MatrixXd(rows).transpose() * Eigen::MatrixXd(weights.asDiagonal() * left);
        EXPECT_LT((products.left(f, u) - left).norm(), 1e-13) << columns;
        EXPECT_LT((products.pull(left) - pull).norm(), 1e-13) << columns;
        EXPECT_LT((products.reduced_pull(f, u, basis(40)) - basis(40).transpose() * pull).norm(),
                  1e-13)
            << columns;
    }
}

TEST_F(RowProductsTest, SeveralThreadsGiveTheSame)
{
    const SparseMatrix rows = sparse(30000, 30000);
    const Eigen::VectorXd weights = dense(30000, 1);
    const Eigen::MatrixXd left = dense(30000, 3);
    const Eigen::MatrixXd expected =
        rows.transpose() * Eigen::MatrixXd(weights.asDiagonal() * left);
    EXPECT_LT((RowProducts(rows, weights).pull(left) - expected).norm(), 1e-11);
}

TEST_F(RowProductsTest, UnknownsAreExpandedToAllTheirRows)
{
    const Eigen::MatrixXd y = dense(7, 2), offset = dense(40, 2);
    EXPECT_LT((expanded(basis(40), y, offset) - (basis(40) * y + offset)).norm(), 1e-14);
}

}  // namespace

}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/row_space.h"

#include <cmath>
#include <gtest/gtest.h>

namespace sheetmorph::numerics
{
namespace
{

constexpr double tolerance = 1e-12;

//! A product whose singular values fall by `decades` every hundred.
struct Graded
{
    Graded(Eigen::Index rows, Eigen::Index columns, Eigen::Index rank, double decades)
        : left(Weights::Random(rows, rank)), right(Weights::Random(columns, rank))
    {
        for (Eigen::Index k = 0; k < rank; ++k)
            left.col(k) *= std::pow(10.0, -decades * static_cast<double>(k) / 100.0);
    }

    Weights product() const { return left * right.transpose(); }

    double worst_miss(const Weights& basis) const
    {
        const Weights whole = product();
        return (whole - whole * basis.transpose() * basis).rowwise().norm().maxCoeff()
               / whole.rowwise().norm().maxCoeff();
    }

    Weights left, right;
};

double off_orthonormal(const Weights& basis)
{
    return (basis * basis.transpose() - Weights::Identity(basis.rows(), basis.rows()))
        .cwiseAbs()
        .maxCoeff();
}

TEST(RowSpaceTest, HasTheRankOfTheProduct)
{
    for (const Eigen::Index rows : {60, 1000})
    {
        const Graded product(rows, 300, 40, 0.0);
        const Weights basis = row_space({product.left, product.right}, 200, tolerance);
        EXPECT_EQ(basis.rows(), 40);
        EXPECT_LT(product.worst_miss(basis), 1e-13);
        EXPECT_LT(off_orthonormal(basis), 1e-13);
    }
}

TEST(RowSpaceTest, LeavesOutSingularValuesBelowTheTolerance)
{
    const Graded product(1500, 700, 300, 10.0);  // a decade every ten
    const Weights basis = row_space({product.left, product.right}, 300, tolerance);
    EXPECT_LT(basis.rows(), 160);
    EXPECT_LT(product.worst_miss(basis), 10.0 * tolerance);
    EXPECT_LT(off_orthonormal(basis), 1e-12);
    EXPECT_GT(product.worst_miss(basis.topRows(100)), 100.0 * tolerance);
}

TEST(RowSpaceTest, SeesEveryOneOfFewRows)
{
    // The first block has one direction, the last row another.
    Graded product(50, 80, 2, 0.0);
    product.left.setZero();
    product.left.col(0).setOnes();
    product.left(49, 1) = 1e-6;
    const Weights basis = row_space({product.left, product.right}, 40, tolerance);
    EXPECT_EQ(basis.rows(), 2);
    EXPECT_LT(product.worst_miss(basis), 1e-13);
}

TEST(RowSpaceTest, IsEmptyIfTheRankIsTooLarge)
{
    const Graded product(500, 300, 40, 0.0);
    EXPECT_EQ(row_space({product.left, product.right}, 39, tolerance).rows(), 0);
    EXPECT_EQ(row_space({product.left, product.right}, 40, tolerance).rows(), 40);
    EXPECT_EQ(row_space({Weights::Zero(30, 4), Weights::Ones(20, 4)}, 10, tolerance).rows(), 0);
}

}  // namespace
}  // namespace sheetmorph::numerics

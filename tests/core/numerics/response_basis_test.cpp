// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response_basis.h"

#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

Eigen::MatrixXd numbers(Eigen::Index rows, Eigen::Index columns)
{
    return Eigen::MatrixXd::NullaryExpr(rows, columns,
                                        [](Eigen::Index i, Eigen::Index k)
                                        { return std::sin(1.7 * i + 0.3 * i * k + k); });
}

// A size is no multiple of a block, one is, and one is worked on by two
// threads.
class ResponseBasisSizes : public testing::TestWithParam<Eigen::Index>
{
};

TEST_P(ResponseBasisSizes, AddsTheProductToTheStart)
{
    const Eigen::Index rows = GetParam(), columns = 25;
    const Eigen::MatrixXd basis = numbers(rows, columns);
    const ResponseBasis::Coefficients coefficients = numbers(columns, 3).cast<float>();
    const Points start = 100.0 * numbers(rows, 3);
    ResponseBasis response(rows, columns);
    response.set_columns(0, basis.leftCols(10));
    response.set_columns(10, basis.rightCols(15));
    Points result;
    response.add_to(start, coefficients, result);
    const Points expected = start + basis * coefficients.cast<double>();
    EXPECT_LT((result - expected).cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_LT((response.row(rows / 2, coefficients).transpose() + start.row(rows / 2)
               - expected.row(rows / 2))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-5);
}

INSTANTIATE_TEST_SUITE_P(All, ResponseBasisSizes, testing::Values(1, 47, 48, 1000, 350001));

TEST(ResponseBasis, LeavesRowsWithoutResponseBitForBitWhereTheyStart)
{
    Eigen::MatrixXd basis = numbers(100, 4);
    basis.row(30).setZero();
    ResponseBasis response(100, 4);
    response.set_columns(0, basis);
    const Points start = numbers(100, 3);
    Points result;
    response.add_to(start, numbers(4, 3).cast<float>(), result);
    EXPECT_EQ(result.row(30), start.row(30));
    EXPECT_NE(result.row(31), start.row(31));
}

TEST(ResponseBasis, WithoutColumnsIsTheStart)
{
    const Points start = numbers(50, 3);
    Points result;
    ResponseBasis(50, 0).add_to(start, ResponseBasis::Coefficients(0, 3), result);
    EXPECT_EQ(result, start);
}

}  // namespace
}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response/response_basis.h"

#include <gtest/gtest.h>

namespace sheetmorph::numerics
{
namespace
{

Eigen::MatrixXd numbers(Eigen::Index rows, Eigen::Index columns)
{
    return Eigen::MatrixXd::NullaryExpr(rows, columns,
                                        [](Eigen::Index i, Eigen::Index k)
                                        { return std::sin(1.7 * i + 0.3 * i * k + k); });
}

Points on_a_line(Eigen::Index rows)
{
    Points places = Points::Zero(rows, 3);
    places.col(0).setLinSpaced(0.0, 1.0);
    return places;
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
    const ResponseBasis::Coefficients coefficients = numbers(columns, 3);
    const Points start = 100.0 * numbers(rows, 3);
    ResponseFields fields(on_a_line(rows), columns);
    fields.append(basis.leftCols(10), Eigen::VectorXd::Constant(10, 1e-9));
    fields.append(basis.rightCols(15), Eigen::VectorXd::Constant(15, 1e-9));
    const ResponseBasis response(fields);
    Points result;
    response.add_to(start, coefficients, result);
    const Points expected = start + basis * coefficients;
    EXPECT_LT((result - expected).cwiseAbs().maxCoeff(), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(All, ResponseBasisSizes, testing::Values(1, 47, 48, 1000, 350001));

// Bumps as features make them: each reaches over many rows, many reach each row.
Eigen::MatrixXd bumps(Eigen::Index rows, Eigen::Index columns)
{
    return Eigen::MatrixXd::NullaryExpr(rows, columns,
                                        [=](Eigen::Index i, Eigen::Index k)
                                        {
                                            const double x =
                                                4.0 * (1.0 * i / rows - 1.0 * k / columns);
                                            return std::exp(-x * x) * (1.0 + 0.3 * std::cos(k));
                                        });
}

TEST(ResponseBasis, KeepsManySmoothColumnsInLittleMemoryAndAsExactlyAsAsked)
{
    const Eigen::Index rows = 10000, columns = 150, together = 50;
    const Eigen::MatrixXd basis = bumps(rows, columns);
    for (const double tolerance : {1e-4, 1e-6, 1e-8})
    {
        ResponseFields fields(on_a_line(rows), columns);
        for (Eigen::Index first = 0; first < columns; first += together)
            fields.append(basis.middleCols(first, together),
                          Eigen::VectorXd::Constant(together, tolerance));
        const ResponseBasis response(fields);
        const ResponseBasis::Coefficients coefficients = numbers(columns, 3);
        const Eigen::MatrixXd expected = basis * coefficients;
        Points result;
        response.add_to(Points::Zero(rows, 3), coefficients, result);
        // What columns miss adds up, and so does the rounding of float32.
        const double allowed = columns * tolerance + 5e-6;
        EXPECT_LT((result - expected).cwiseAbs().maxCoeff(), allowed);
        EXPECT_LT((fields.times(coefficients) - expected).cwiseAbs().maxCoeff(), allowed);
        EXPECT_LT(response.bytes(), 40.0 * rows) << "150 columns of float32 are 600 a row";
    }
}

// Files number vertices by face, by element or as a hash had them.
TEST(ResponseBasis, TakesAsLittleMemoryHoweverRowsAreNumbered)
{
    const Eigen::Index rows = 9973, columns = 150;
    const Eigen::MatrixXd basis = bumps(rows, columns);
    const auto mixed = [](Eigen::Index row) { return row * 5003 % 9973; };
    Points places = on_a_line(rows), mixed_places(rows, 3);
    Eigen::MatrixXd mixed_basis(rows, columns);
    for (Eigen::Index row = 0; row < rows; ++row)
    {
        mixed_places.row(mixed(row)) = places.row(row);
        mixed_basis.row(mixed(row)) = basis.row(row);
    }
    const Eigen::VectorXd tolerances = Eigen::VectorXd::Constant(columns, 1e-6);
    ResponseFields fields(places, columns), mixed_fields(mixed_places, columns);
    fields.append(basis, tolerances);
    mixed_fields.append(mixed_basis, tolerances);
    const ResponseBasis::Coefficients coefficients = numbers(columns, 3);
    Points result;
    const ResponseBasis mixed_response(mixed_fields);
    mixed_response.add_to(Points::Zero(rows, 3), coefficients, result);
    const Points expected = mixed_basis * coefficients;
    EXPECT_LT((result - expected).cwiseAbs().maxCoeff(), 2e-4);
    EXPECT_LT((mixed_fields.times(coefficients) - expected).cwiseAbs().maxCoeff(), 2e-4);
    EXPECT_LT((mixed_fields.row(77) - mixed_basis.row(77)).cwiseAbs().maxCoeff(), 2e-6);
    // A row that is a run of its own costs 8 bytes more.
    EXPECT_LT(mixed_response.bytes(), ResponseBasis(fields).bytes() + 9.0 * rows);
}

TEST(ResponseBasis, LeavesRowsWithoutResponseBitForBitWhereTheyStart)
{
    Eigen::MatrixXd basis = numbers(100, 4);
    basis.row(30).setZero();
    ResponseFields fields(on_a_line(100));
    fields.append(basis, Eigen::VectorXd::Constant(4, 1e-9));
    const ResponseBasis response(fields);
    const Points start = numbers(100, 3);
    Points result;
    response.add_to(start, numbers(4, 3), result);
    EXPECT_EQ(result.row(30), start.row(30));
    EXPECT_NE(result.row(31), start.row(31));
}

TEST(ResponseBasis, WithoutColumnsIsTheStart)
{
    const Points start = numbers(50, 3);
    Points result;
    ResponseBasis(ResponseFields(on_a_line(50)))
        .add_to(start, ResponseBasis::Coefficients(0, 3), result);
    EXPECT_EQ(result, start);
}

}  // namespace
}  // namespace sheetmorph::numerics

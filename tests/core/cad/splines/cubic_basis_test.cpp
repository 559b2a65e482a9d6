// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/cubic_basis.h"

#include <gtest/gtest.h>

#include <numeric>

namespace sheetmorph::cad
{

namespace
{

double cubic(double t)
{
    return 2.0 - t + 0.5 * t * t - 0.25 * t * t * t;
}

// The value, or a derivative, of the spline of coefficients.
double sum(const CubicBasis& basis, const Eigen::MatrixXd& poles, double t, int derivative = 0)
{
    const CubicBasis::Row row = basis.row(t, derivative);
    double found = 0.0;
    for (int k = 0; k < 4; ++k)
        found += row.weights[static_cast<std::size_t>(k)] * poles(row.first + k, 0);
    return found;
}

Eigen::MatrixXd poles_of_cubic(const CubicBasis& basis)
{
    const std::vector<double> places = basis.greville();
    Eigen::MatrixXd values(static_cast<Eigen::Index>(places.size()), 1);
    for (std::size_t i = 0; i < places.size(); ++i)
        values(static_cast<Eigen::Index>(i), 0) = cubic(places[i]);
    return basis.through(places, values);
}

}  // namespace

TEST(CubicBasisTest, ItsSplinesSumToOneEverywhere)
{
    const CubicBasis basis(-1.0, 3.0, {{0.0, 1}, {1.0, 2}, {2.5, 3}});
    EXPECT_EQ(basis.count(), 10);
    for (double t = -1.0; t <= 3.0; t += 0.0625)
    {
        const auto weights = basis.row(t).weights;
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-14);
        const auto slopes = basis.row(t, 1).weights;
        EXPECT_NEAR(std::accumulate(slopes.begin(), slopes.end(), 0.0), 0.0, 1e-13);
    }
}

TEST(CubicBasisTest, ACubicIsInterpolatedExactlyWithItsDerivatives)
{
    const CubicBasis basis(-1.0, 3.0, {{0.0, 1}, {1.0, 2}});
    const Eigen::MatrixXd poles = poles_of_cubic(basis);
    for (double t = -1.0; t <= 3.0; t += 0.11)
    {
        EXPECT_NEAR(sum(basis, poles, t), cubic(t), 1e-13);
        EXPECT_NEAR(sum(basis, poles, t, 1), -1.0 + t - 0.75 * t * t, 1e-12);
        EXPECT_NEAR(sum(basis, poles, t, 2), 1.0 - 1.5 * t, 1e-11);
    }
}

TEST(CubicBasisTest, OutsideTheSplineGoesOnAsTheCubicOfItsEnds)
{
    const CubicBasis basis(0.0, 1.0, {{0.5, 1}});
    const Eigen::MatrixXd poles = poles_of_cubic(basis);
    for (const double t : {-0.2, 1.3})
        EXPECT_NEAR(sum(basis, poles, t), cubic(t), 1e-12);
}

TEST(CubicBasisTest, OnlyChosenSpansAreHalvedAndKinksStay)
{
    const CubicBasis basis(0.0, 4.0, {{1.0, 3}, {2.0, 1}});
    const CubicBasis finer = basis.halved({false, true, true});
    EXPECT_EQ(finer.ends(), (std::vector<double>{0.0, 1.0, 1.5, 2.0, 3.0, 4.0}));
    EXPECT_EQ(finer.count(), basis.count() + 2);
    EXPECT_EQ(finer.span_of(1.2), 1);
    EXPECT_EQ(finer.span_of(-5.0), 0);
    EXPECT_EQ(finer.span_of(9.0), 4);
}

}  // namespace sheetmorph::cad

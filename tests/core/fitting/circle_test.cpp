// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/circle.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"
#include "shapes.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

namespace sheetmorph::fitting
{

namespace
{

using testing::SizeIs;

// `count` points over a part of a circle (1: all around) in a turned plane.
Points arc(int count, double part, double radius, const Vector3& centre)
{
    const Matrix3 frame = rotation_from_log(Vector3(0.3, -0.5, 0.7));
    Points points(count, 3);
    for (int i = 0; i < count; ++i)
    {
        const double angle = 2 * shapes::pi * part * i / count;
        const Vector3 flat(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        points.row(i) = (centre + frame * flat).transpose();
    }
    return points;
}

}  // namespace

TEST(Circle, ThroughAnExactCircleIsExact)
{
    const Vector3 centre(1, -2, 3);
    const CircleFit fit = fit_circle(arc(17, 1.0, 4.5, centre));
    EXPECT_NEAR(fit.radius, 4.5, 1e-14 * 4.5);
    EXPECT_LT((fit.centre - centre).norm(), 1e-14);
    EXPECT_LT((fit.axis - rotation_from_log(Vector3(0.3, -0.5, 0.7)).col(2)).norm(), 1e-14);
    EXPECT_LT(fit.residual, 1e-14);
}

TEST(Circle, FarFromTheOriginLosesOnlyTheRoundingOfTheCoordinates)
{
    const Vector3 centre(1e5, -3e5, 2e5);
    const CircleFit fit = fit_circle(arc(48, 1.0, 60.0, centre));
    EXPECT_NEAR(fit.radius, 60.0, 1e-12 * 60.0);
    EXPECT_LT((fit.centre - centre).norm(), 6e-11);
    EXPECT_LT(fit.residual, 2e-10);
}

TEST(Circle, ThroughAShortArcOrThreePointsIsFound)
{
    EXPECT_NEAR(fit_circle(arc(9, 0.05, 4.5, {1, 2, 3})).radius, 4.5, 1e-10);
    EXPECT_NEAR(fit_circle(arc(3, 0.6, 4.5, {1, 2, 3})).radius, 4.5, 1e-13);
}

TEST(Circle, OfNoisyPointsHasNoBetterNeighbour)
{
    Points points = arc(12, 0.6, 10.0, {5, 6, 7});
    std::srand(3);
    points += 0.2 * Points::Random(12, 3);
    const CircleFit fit = fit_circle(points);
    const auto cost = [&](const Vector3& centre, double radius)
    {
        double sum = 0.0;
        for (int i = 0; i < 12; ++i)
        {
            const Vector3 out = points.row(i).transpose() - centre;
            const Vector3 flat = out - fit.axis * fit.axis.dot(out);
            sum += std::pow(flat.norm() - radius, 2);
        }
        return sum;
    };
    const double best = cost(fit.centre, fit.radius);
    const Vector3 across = fit.axis.unitOrthogonal();
    for (const double shift : {-1e-3, 1e-3})
    {
        EXPECT_GT(cost(fit.centre + shift * across, fit.radius), best);
        EXPECT_GT(cost(fit.centre + shift * fit.axis.cross(across), fit.radius), best);
        EXPECT_GT(cost(fit.centre, fit.radius + shift), best);
    }
}

TEST(Circle, ResidualIsTheLargestDistanceFromIt)
{
    Points square(4, 3);
    square << 1, 1, 0, -1, 1, 0, -1, -1, 0, 1, -1, 0;
    EXPECT_NEAR(fit_circle(square).residual, 0.0, 1e-14);
    square.col(2) << 0.1, -0.1, 0.1, -0.1;
    EXPECT_NEAR(fit_circle(square).residual, 0.1, 1e-14);
}

TEST(Circle, AxisFollowsTheSenseOfThePoints)
{
    const Points points = arc(12, 1.0, 2.0, {0, 0, 0});
    const Points reversed = points.colwise().reverse();
    EXPECT_LT((fit_circle(points).axis + fit_circle(reversed).axis).norm(), 1e-14);
}

TEST(Circle, TooFewOrStraightOrInfinitePointsAreRefused)
{
    EXPECT_THROW(fit_circle(Points::Random(2, 3)), InvalidInput);
    Points straight(5, 3);
    for (int i = 0; i < 5; ++i)
        straight.row(i) = Eigen::RowVector3d(1e4, 2e4, 3e4) + i * Eigen::RowVector3d(0.1, 0.7, 0.3);
    EXPECT_THROW(fit_circle(straight), InvalidInput);
    EXPECT_THROW(fit_circle(Points::Ones(4, 3)), InvalidInput);
    straight(2, 1) = std::nan("");
    EXPECT_THROW(fit_circle(straight), InvalidInput);
}

TEST(Circle, TellsWhenItDidNotSettle)
{
    EXPECT_TRUE(fit_circle(shapes::annulus(24, 2, 5, 8).points()).convergence.is_converged);
    // Scattered about a line: circles on both sides of it are as good.
    Points points(7, 3);
    points << -1.0, -0.7, 0, -2.0 / 3.0, -0.8, 0, -1.0 / 3.0, 0.3, 0, 0, -0.2, 0, 1.0 / 3.0, 0.1, 0,
        2.0 / 3.0, 0.8, 0, 1.0, 0.9, 0;
    const CircleFit lost = fit_circle(points);
    EXPECT_FALSE(lost.convergence.is_converged);
    EXPECT_EQ(lost.convergence.rounds, 100);
    EXPECT_GT(lost.convergence.miss, 1e-9 * lost.radius);
    EXPECT_EQ(lost.convergence.sentence().find("the circle's position and radius did not converge"),
              0U);
}

}  // namespace sheetmorph::fitting

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/pick/screen.h"

#include "sheetmorph/base/errors.h"
#include "cameras.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace sheetmorph::pick
{

namespace
{

ScreenOutline outline_of(std::initializer_list<double> numbers)
{
    ScreenPoints corners(static_cast<Eigen::Index>(numbers.size() / 2), 2);
    std::copy(numbers.begin(), numbers.end(), corners.data());
    return ScreenOutline(corners);
}

// 500 places within 60 mm of the origin along every axis.
std::vector<Vector3> some_points()
{
    std::mt19937 random(5);
    const auto number = [&] { return 120.0 * (random() / 4294967296.0) - 60.0; };
    std::vector<Vector3> points(500);
    for (Vector3& point : points)
        for (int c = 0; c < 3; ++c)
            point(c) = number();
    return points;
}

}  // namespace

TEST(Screen, AParallelCameraShowsPixelsFromTheLowerLeftAndDepthAwayFromTheEye)
{
    const Screen screen = cameras::parallel_from_above(100.0);
    EXPECT_LT((screen.seen({0, 0, 0}) - Vector3(400, 300, 0)).norm(), 1e-10);
    EXPECT_LT((screen.seen({10, 10, 50}) - Vector3(460, 360, -0.5)).norm(), 1e-10);
}

TEST(Screen, APerspectiveCameraShowsWhatIsFartherSmallerAndNothingBehindTheEye)
{
    const Screen screen = cameras::perspective_from_above(100.0);
    const double near = screen.seen({10, 0, 20}).x() - 400.0;
    const double far = screen.seen({10, 0, -20}).x() - 400.0;
    EXPECT_NEAR(near / far, 120.0 / 80.0, 1e-10);
    EXPECT_LT(screen.seen({10, 0, 20}).z(), screen.seen({10, 0, -20}).z());
    EXPECT_EQ(screen.seen({0, 0, 101}).x(), std::numeric_limits<double>::infinity());
}

TEST(Screen, DepthIsLinearOverAFlatTriangleInPerspective)
{
    const Screen screen = cameras::perspective_from_above(100.0);
    const Vector3 a = screen.seen({-30, 5, 40});
    const Vector3 b = screen.seen({25, 11, -60});
    const Vector3 between = screen.seen(0.3 * Vector3(-30, 5, 40) + 0.7 * Vector3(25, 11, -60));
    const double along = (between.x() - a.x()) / (b.x() - a.x());
    EXPECT_NEAR(between.z(), a.z() + along * (b.z() - a.z()), 1e-12);
}

TEST(Screen, PlanesAroundARectangleSeparateWhatIsSeenInIt)
{
    for (const Screen& screen :
         {cameras::parallel_from_above(100.0), cameras::perspective_from_above(100.0)})
    {
        const mesh::Planes planes = screen.planes_around({300, 250, -1}, {420, 500, 0.7});
        for (const Vector3& point : some_points())
        {
            const Vector3 seen = screen.seen(point);
            const bool is_in = seen.x() > 300 && seen.x() < 420 && seen.y() > 250 && seen.y() < 500
                               && seen.z() < 0.7;
            const double least = (planes.leftCols<3>() * point + planes.col(3)).minCoeff();
            EXPECT_EQ(least >= 0.0, is_in);
        }
    }
}

TEST(Screen, FaultsAreToldInWords)
{
    Matrix4 broken = Matrix4::Identity();
    broken(1, 2) = std::nan("");
    EXPECT_THROW(Screen(broken, 800, 600), InvalidInput);
    EXPECT_THROW(Screen(Matrix4::Identity(), 800, 0), InvalidInput);
    EXPECT_THROW(outline_of({0, 0, 1, 1}), InvalidInput);
    EXPECT_THROW(outline_of({0, 0, 1, 1, 0, std::nan("")}), InvalidInput);
}

TEST(ScreenOutline, ContainsWhatIsInsideWhicheverWayItRuns)
{
    for (const ScreenOutline& outline : {outline_of({0, 0, 10, 0, 10, 10, 5, 2, 0, 10}),
                                         outline_of({0, 10, 5, 2, 10, 10, 10, 0, 0, 0})})
    {
        EXPECT_TRUE(outline.contains(5, 1));
        EXPECT_TRUE(outline.contains(1, 7));
        EXPECT_FALSE(outline.contains(5, 3));
        EXPECT_FALSE(outline.contains(-1, 5));
        EXPECT_FALSE(outline.contains(5, 11));
    }
}

TEST(ScreenOutline, WhatItRunsRoundTwiceIsInside)
{
    const ScreenOutline twice =
        outline_of({0, 0, 10, 0, 10, 10, 0, 10, 0, 0, 4, 4, 6, 4, 6, 6, 4, 6, 4, 4});
    EXPECT_TRUE(twice.contains(5, 5));
    EXPECT_TRUE(twice.contains(8, 2));
}

TEST(ScreenOutline, OneThatCrossesItselfHoldsBothHalves)
{
    const ScreenOutline eight = outline_of({0, 0, 10, 10, 10, 0, 0, 10});
    EXPECT_TRUE(eight.contains(9, 5));
    EXPECT_TRUE(eight.contains(1, 5));
    EXPECT_FALSE(eight.contains(5, 9));
}

TEST(ScreenOutline, OneWithoutExtentHoldsNothing)
{
    EXPECT_FALSE(outline_of({3, 3, 3, 3, 3, 3}).contains(3, 3));
    EXPECT_FALSE(outline_of({0, 3, 9, 3, 4, 3}).contains(5, 3));
}

}  // namespace sheetmorph::pick

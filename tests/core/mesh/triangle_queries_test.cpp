// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/triangle_queries.h"

#include <gtest/gtest.h>

#include <limits>

namespace sheetmorph
{

namespace
{

const TriangleCorners corners{Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 4, 0)};
constexpr double far_away = std::numeric_limits<double>::infinity();

}  // namespace

TEST(TriangleQueries, ARayMeetsTheBorderOfATriangleToo)
{
    Hit hit;
    for (const Vector3& place : {Vector3(0, 0, 0), Vector3(2, 2, 0), Vector3(4, 0, 0)})
    {
        const Vector3 above = place + Vector3(0, 0, 3);
        EXPECT_TRUE(TriangleRay(above, {0, 0, -1}, 4.0).meets(corners, hit));
        EXPECT_DOUBLE_EQ(hit.distance, 3.0);
        EXPECT_LT((hit.point - place).norm(), 1e-15);
    }
    EXPECT_FALSE(TriangleRay({2.1, 2.1, 3}, {0, 0, -1}, 4.0).meets(corners, hit));
    EXPECT_FALSE(TriangleRay({1, 1, -3}, {0, 0, -1}, 4.0).meets(corners, hit));
}

TEST(TriangleQueries, ARayInThePlaneOfABoxSideEntersTheBox)
{
    const Vector3 low(0, 0, 0);
    const Vector3 high(1, 1, 0);
    EXPECT_NEAR(TriangleRay({-2, 0, 0}, {1, 0, 0}, 2.0).entry(low, high), 2.0, 1e-12);
    EXPECT_NEAR(TriangleRay({-2, 1, 0}, {1, 0, 0}, 2.0).entry(low, high), 2.0, 1e-12);
    EXPECT_EQ(TriangleRay({0.5, 0.5, 0}, {0, 0, 1}, 2.0).entry(low, high), 0.0);
    EXPECT_EQ(TriangleRay({-2, 1.1, 0}, {1, 0, 0}, 2.0).entry(low, high), far_away);
    EXPECT_EQ(TriangleRay({-2, 0, 0}, {-1, 0, 0}, 2.0).entry(low, high), far_away);
}

TEST(TriangleQueries, TheNearestPlaceIsInsideOnAnEdgeOrAtACorner)
{
    EXPECT_LT((nearest_on_triangle({1, 1, 7}, corners).point - Vector3(1, 1, 0)).norm(), 1e-15);
    EXPECT_LT((nearest_on_triangle({1, -2, 0}, corners).point - Vector3(1, 0, 0)).norm(), 1e-15);
    EXPECT_LT((nearest_on_triangle({4, 4, 0}, corners).point - Vector3(2, 2, 0)).norm(), 1e-15);
    EXPECT_LT((nearest_on_triangle({9, -3, 1}, corners).point - Vector3(4, 0, 0)).norm(), 1e-15);
}

}  // namespace sheetmorph

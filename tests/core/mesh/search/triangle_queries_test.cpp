// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/triangle_queries.h"

#include "sheetmorph/base/errors.h"

#include <gtest/gtest.h>

#include <limits>

namespace sheetmorph::mesh
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

TEST(TriangleQueries, TheFirstHitWithoutATreeIsThatOfTheTree)
{
    Points points(6, 3);
    points << 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 1, 4, 0, 1, 0, 4, 1;
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 3, 4, 5;
    const PickingTree tree{TriangleMesh(points, triangles)};
    for (const Vector3& direction : {Vector3(0, 0.1, -2), Vector3(0.2, 0, 3)})
    {
        const Vector3 origin = Vector3(1, 1, 0.5) - 9.0 * direction;
        const auto found = first_hit(points, triangles, origin, direction);
        const auto wanted = tree.nearest_hit(origin, direction);
        ASSERT_TRUE(found && wanted);
        EXPECT_EQ(found->triangle, wanted->triangle);
        EXPECT_EQ(found->distance, wanted->distance);
        EXPECT_EQ(found->point, wanted->point);
    }
    EXPECT_FALSE(first_hit(points, triangles, {9, 9, 9}, {0, 0, -1}));
    EXPECT_THROW(first_hit(points, triangles, {1, 1, 9}, {0, 0, 0}), InvalidInput);
    EXPECT_THROW(first_hit(points.topRows(4), triangles, {1, 1, 9}, {0, 0, -1}), InvalidInput);
}

// The distance to a convex set has one minimum: no place nearby on the triangle is nearer.
TEST(TriangleQueries, NoPlaceOnATriangleIsNearerThanTheNearestOne)
{
    std::srand(7);
    for (int round = 0; round < 300; ++round)
    {
        TriangleCorners triangle;
        for (Vector3& corner : triangle)
            corner = Vector3::Random();
        const Vector3 point = 2.0 * Vector3::Random();
        const Hit hit = nearest_on_triangle(point, triangle);
        EXPECT_NEAR(hit.barycentric.sum(), 1.0, 1e-12);
        EXPECT_GE(hit.barycentric.minCoeff(), 0.0);
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place += hit.barycentric(k) * triangle[static_cast<std::size_t>(k)];
        EXPECT_LT((place - hit.point).norm(), 1e-12);
        EXPECT_NEAR((hit.point - point).norm(), hit.distance, 1e-12);
        for (const double share : {1.0, 0.1, 1e-3})
            for (const Vector3& corner : triangle)
            {
                const Vector3 other = place + share * (corner - place);
                EXPECT_GE((other - point).norm(), hit.distance - 1e-12) << round;
            }
    }
}

}  // namespace sheetmorph::mesh

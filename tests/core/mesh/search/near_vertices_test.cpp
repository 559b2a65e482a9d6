// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/near_vertices.h"

#include "sheetmorph/base/errors.h"
#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

using Pairs = std::vector<std::pair<int, int>>;

TEST(NearVertices, ArePairedUpToTheToleranceWhereverTheyLie)
{
    const Points random = Points::Random(2000, 3);
    Points points(4000, 3);
    points << random, random;
    for (int i = 0; i < 2000; ++i)
        points(2000 + i, i % 3) += (i % 2 ? 0.9e-6 : 1.1e-6);
    Pairs wanted;
    for (int i = 1; i < 2000; i += 2)
        wanted.emplace_back(i, 2000 + i);
    EXPECT_EQ(near_pairs(points, 1e-6), wanted);
}

TEST(NearVertices, WithoutToleranceOnlyEqualOnesAre)
{
    Points points(4, 3);
    points << 1, 2, 3, 0, 0, 0, 1, 2, 3, 1e-23, 0, 0;
    EXPECT_EQ(near_pairs(points, 0.0), Pairs({{0, 2}}));
    EXPECT_EQ(near_pairs(points, 1e-9), Pairs({{0, 2}, {1, 3}}));
    EXPECT_TRUE(near_pairs(Points(0, 3), 1.0).empty());
}

TEST(NearVertices, AreWeldedOverChains)
{
    Points points(5, 3);
    points << 9, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 0, 0;
    const Weld found = weld(TriangleMesh(points, Triangles{{0, 1, 2}, {2, 3, 4}}), 1.0);
    EXPECT_EQ(found.first, std::vector<int>({0, 1, 1, 1, 4}));
    EXPECT_EQ(found.near, 2);
    EXPECT_EQ(found.equal, 0);
}

TEST(NearVertices, AreThoseThatAComparisonOfAllPointsFinds)
{
    std::srand(3);
    const Points points = Points::Random(700, 3);
    const double tolerance = 0.12;
    Pairs wanted;
    for (int i = 0; i < points.rows(); ++i)
        for (int j = i + 1; j < points.rows(); ++j)
            if ((points.row(i) - points.row(j)).norm() <= tolerance)
                wanted.emplace_back(i, j);
    EXPECT_GT(wanted.size(), 100U);
    EXPECT_EQ(near_pairs(points, tolerance), wanted);
}

// Two sheets meet at their borders; two closed bodies that touch stay two.
TEST(NearVertices, OfTwoPiecesAreWeldedAtOpenEdgesOnly)
{
    Points corners(6, 3);
    corners << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 1e-9, 0, 1, 1e-9, 1, 1, 0;
    EXPECT_EQ(weld(TriangleMesh(corners, Triangles{{0, 1, 2}, {3, 5, 4}}), 1e-6).first,
              std::vector<int>({0, 1, 2, 1, 2, 5}));
    Points two(8, 3);
    two << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1e-9, 2, 0, 0, 1, 1, 0, 1, 0, 1;
    const Triangles bodies{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3},
                           {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}};
    EXPECT_EQ(weld(TriangleMesh(two, bodies), 1e-6).first,
              std::vector<int>({0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(NearVertices, NeedATolerance)
{
    EXPECT_THROW(near_pairs(Points::Zero(2, 3), -1.0), InvalidInput);
    EXPECT_THROW(near_pairs(Points::Zero(2, 3), std::nan("")), InvalidInput);
}

}  // namespace
}  // namespace sheetmorph::mesh

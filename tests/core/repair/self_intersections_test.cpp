// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/self_intersections.h"

#include "shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace sheetmorph::repair
{

using namespace mesh;
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(SelfIntersections, OfASoundSolidAreNone)
{
    EXPECT_THAT(self_intersections(shapes::box(4, Vector3(30, 20, 2))), IsEmpty());
}

TEST(SelfIntersections, AreThePairsThatCross)
{
    Points points(6, 3);
    points << 0, 0, 0, 10, 0, 0, 0, 10, 0, 1, 1, -1, 2, 1, 3, 1, 2, 3;
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 3, 4, 5;
    EXPECT_THAT(self_intersections(TriangleMesh(points, triangles)), ElementsAre(Pair(0, 1)));
    points.bottomRows(3).col(2).array() += 5.0;
    EXPECT_THAT(self_intersections(TriangleMesh(points, triangles)), IsEmpty());
}

TEST(SelfIntersections, AreFoundWhereASkinGoesThroughTheOther)
{
    const TriangleMesh box = shapes::box(4, Vector3(30, 20, 2));
    Points points = box.points();
    for (int i = 0; i < box.vertex_count(); ++i)
        if (points(i, 2) > 1.5 && points(i, 0) > 7.0 && points(i, 0) < 23.0 && points(i, 1) > 4.0
            && points(i, 1) < 16.0)
            points(i, 2) = -1.0;
    EXPECT_GT(self_intersections(TriangleMesh(points, box.triangles())).size(), 0U);
}

TEST(SelfIntersections, AreNotWhatThreeSheetsShareAtAnEdge)
{
    Points points(8, 3);
    points << 0, 0, 0, 0, 30, 0, 20, 0, 0, 20, 30, 0, -20, 0, 0, -20, 30, 0, 0, 0, 20, 0, 30, 20;
    Triangles triangles(6, 3);
    triangles << 0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4, 0, 1, 7, 0, 7, 6;
    EXPECT_THAT(self_intersections(TriangleMesh(points, triangles)), IsEmpty());
}

// One that repeats a vertex shares up to nine corners with another.
TEST(SelfIntersections, AreNotOfTrianglesThatRepeatAVertex)
{
    Points points(3, 3);
    points << 0, 0, 3, 0, 1, 2, 5, 1, 2;
    Triangles triangles(4, 3);
    triangles << 1, 0, 1, 1, 1, 1, 0, 1, 2, 0, 0, 2;
    EXPECT_THAT(self_intersections(TriangleMesh(points, triangles)), IsEmpty());
}

// Whether two triangles meet away from the corners they share, by sides alone: none goes through
// the other triangle. In general position that is the same.
bool cross_by_sides(const TriangleMesh& mesh)
{
    const auto place = [&](int t, int k) -> Vector3
    { return mesh.points().row(mesh.triangles()(t, k)); };
    for (const int t : {0, 1})
        for (int k = 0; k < 3; ++k)
        {
            const Vector3 from = place(t, k), way = place(t, (k + 1) % 3) - from;
            Eigen::Matrix3d sides;
            sides << -way, place(1 - t, 1) - place(1 - t, 0), place(1 - t, 2) - place(1 - t, 0);
            const Vector3 found = sides.inverse() * (from - place(1 - t, 0));
            constexpr double inside = 1e-9;
            if (found.tail<2>().minCoeff() > -inside && found.tail<2>().sum() < 1.0 + inside
                && found(0) > inside && found(0) < 1.0 - inside)
                return true;
        }
    return false;
}

TEST(SelfIntersections, AreThoseOfTheSidesForAnyTwoTriangles)
{
    std::mt19937 chance(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (const int shared : {0, 1})
    {
        Triangles triangles(2, 3);
        triangles << 0, 1, 2, shared == 1 ? 1 : 5, 3, 4;
        int crossed = 0;
        for (int trial = 0; trial < 20000; ++trial)
        {
            const Points points = Points::NullaryExpr(6 - shared, 3, [&] { return any(chance); });
            const TriangleMesh mesh(points, triangles);
            const bool do_cross = cross_by_sides(mesh);
            ASSERT_EQ(self_intersections(mesh).size(), do_cross ? 1U : 0U) << points;
            crossed += do_cross;
        }
        EXPECT_GT(crossed, 1000);
    }
}

// What lies in one plane is where the exact predicates decide: a corner is moved by the last digit.
TEST(SelfIntersections, AreExactWhereTrianglesTouch)
{
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 3, 4, 5;
    for (const double size : {1e-3, 1.0, 1e5})
        for (const int digits : {-1, 0, 1})
        {
            const double edge = digits == 0  ? size
                                : digits < 0 ? std::nextafter(size, 0.0)
                                             : std::nextafter(size, 2.0 * size);
            Points points(6, 3);
            points << 0, 0, 0, size, 0, 0, 0, size, 0, edge, 0, 0, 3 * size, 0, 0, 2 * size, size,
                0;
            EXPECT_EQ(self_intersections(TriangleMesh(points, triangles)).empty(), digits > 0);
        }
}

TEST(SelfIntersections, AreOfATriangleFoldedOntoItsNeighbour)
{
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 1, 0, 3;
    for (const double height : {-5.0, -1e-3, 1e-3, 5.0})
    {
        Points points(4, 3);
        points << 0, 0, 0, 10, 0, 0, 4, 5, 0, 6, height, 0;
        EXPECT_EQ(self_intersections(TriangleMesh(points, triangles)).empty(), height < 0.0);
        points(3, 2) = 1e-6;
        EXPECT_THAT(self_intersections(TriangleMesh(points, triangles)), IsEmpty());
    }
}

}  // namespace
}  // namespace sheetmorph::repair

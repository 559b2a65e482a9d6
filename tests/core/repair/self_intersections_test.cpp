// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/self_intersections.h"

#include "shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sheetmorph
{
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

}  // namespace
}  // namespace sheetmorph

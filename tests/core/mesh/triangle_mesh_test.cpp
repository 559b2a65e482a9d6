// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/triangle_mesh.h"

#include "sheetmorph/base/errors.h"

#include <gmock/gmock.h>
#include <limits>

namespace sheetmorph::mesh
{
namespace
{

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

Points three_points()
{
    Points points(3, 3);
    points << 0, 0, 0, 30, 0, 0, 0, 40, 0;
    return points;
}

TEST(TriangleMesh, ItsSizeIsTheDiagonalOfItsBox)
{
    Triangles triangles(1, 3);
    triangles << 0, 1, 2;
    for (const double away : {0.0, 500.0, -2000.0})
    {
        const Points points = three_points().array() + away;
        EXPECT_DOUBLE_EQ(TriangleMesh(points, triangles).size(), 50.0) << away;
    }
    EXPECT_EQ(TriangleMesh().size(), 0.0);
}

TEST(TriangleMesh, NamesPointsThatAreNotFinite)
{
    Points points = three_points();
    points(1, 2) = std::numeric_limits<double>::infinity();
    EXPECT_THAT([&] { TriangleMesh(points, Triangles(0, 3)); },
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("not finite"), HasSubstr("1"))));
}

TEST(TriangleMesh, NamesTrianglesWithIndicesOutOfRange)
{
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 0, 1, 3;
    EXPECT_THAT([&] { TriangleMesh(three_points(), triangles); },
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("0..2"), HasSubstr(": 1"))));
}

TEST(TriangleMesh, ExactnessGrowsWithSizeAndDistanceFromTheOrigin)
{
    EXPECT_DOUBLE_EQ(exactness(Points::Zero(2, 3), 100.0), 1e-10);
    EXPECT_GT(exactness(Points::Constant(2, 3, 1e6), 100.0), 1.7e-9);
}

}  // namespace
}  // namespace sheetmorph::mesh

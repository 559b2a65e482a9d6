// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/thinness.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{

namespace
{

bool is_thin_with_height(double height, double scale)
{
    Points points(3, 3);
    points << 0, 0, 0, 1, 0, 0, 0.5, height, 0;
    points *= scale;
    return is_thin(points, Triangles(Eigen::RowVector3i(0, 1, 2)), 0);
}

}  // namespace

TEST(Thinness, DoesNotDependOnTheUnit)
{
    for (const double scale : {1e-6, 1.0, 1e6})
    {
        EXPECT_FALSE(is_thin_with_height(2e-5, scale));
        EXPECT_TRUE(is_thin_with_height(0.5e-5, scale));
    }
}

TEST(Thinness, ARepeatedVertexOrAPointIsThin)
{
    const Points points = Points::Random(3, 3);
    EXPECT_TRUE(is_thin(points, Triangles(Eigen::RowVector3i(0, 1, 1)), 0));
    EXPECT_TRUE(is_thin(points, Triangles(Eigen::RowVector3i(2, 2, 2)), 0));
}

}  // namespace sheetmorph::mesh

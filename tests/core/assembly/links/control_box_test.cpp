// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/control_box.h"

#include "sheetmorph/base/rotation.h"
#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

TEST(ControlBox, PointsAreInsideWhereNoCoordinateIsBeyondASide)
{
    const volume::OrientedBox box{rotation_from_log(Vector3(0.4, -0.3, 0.8)),
                                  Vector3(10.0, -20.0, 30.0), Vector3(5.0, 2.0, 0.5),
                                  Vector3::Zero()};
    Points local(8, 3);
    local << 0, 0, 0,      //
        4.9, -1.9, 0.49,   //
        -4.9, 1.9, -0.49,  //
        5.1, 0, 0,         //
        0, -2.1, 0,        //
        0, 0, 0.51,        //
        -5.1, 2.1, 0,      //
        6, 6, 6;
    const Points points = (local * box.axes.transpose()).rowwise() + box.centre.transpose();
    EXPECT_EQ(inside(box, points), (std::vector<char>{1, 1, 1, 0, 0, 0, 0, 0}));
    EXPECT_TRUE(inside(box, Points(0, 3)).empty());
}

// A point has no size of its own: its box grows with the assembly.
TEST(ControlBox, OfASinglePointIsAShareOfTheAssembly)
{
    const auto sides = [](double scale)
    {
        Assembly assembly;
        assembly.parts.push_back(
            {"sheet", shapes::grid(10, 4, 100.0 * scale, 40.0 * scale), {}, Mode::automatic});
        const ControlBoxes boxes(assembly);
        return boxes.around(assembly.parts[0].mesh.points().topRows(1), 0).half_extents;
    };
    const Vector3 once = sides(1.0);
    EXPECT_GT(once.minCoeff(), 0.1);
    EXPECT_LT(once.maxCoeff(), 10.0);
    for (const double scale : {0.001, 10.0})
        EXPECT_LT((sides(scale) - scale * once).norm(), 1e-9 * scale);
}

TEST(ControlBox, StackedRowsAreThoseOfBoth)
{
    const Points all = Points::Random(6, 3);
    const Points found = stacked(rows_of(all, {4, 0}), rows_of(all, {2}));
    ASSERT_EQ(found.rows(), 3);
    EXPECT_EQ(found.row(0), all.row(4));
    EXPECT_EQ(found.row(1), all.row(0));
    EXPECT_EQ(found.row(2), all.row(2));
}

}  // namespace
}  // namespace sheetmorph::assembly

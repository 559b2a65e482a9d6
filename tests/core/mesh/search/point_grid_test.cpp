// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/point_grid.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

VertexIds found_in(const PointGrid& grid, const Vector3& low, const Vector3& high)
{
    VertexIds found;
    grid.for_each_in(low, high, [&](int point) { found.push_back(point); });
    std::sort(found.begin(), found.end());
    return found;
}

TEST(PointGrid, FindsWhatABoxHoldsOnceWhateverTheCells)
{
    std::srand(5);
    const Points points = Points::Random(400, 3);
    for (const double side : {0.02, 0.3, 5.0})
    {
        const PointGrid grid(points, side);
        for (int k = 0; k < 40; ++k)
        {
            const Vector3 low = Vector3::Random(), high = low + Vector3(0.4, 0.1, 0.3);
            VertexIds expected;
            for (int i = 0; i < 400; ++i)
                if ((points.row(i).transpose().array() >= low.array()).all()
                    && (points.row(i).transpose().array() <= high.array()).all())
                    expected.push_back(i);
            EXPECT_EQ(found_in(grid, low, high), expected);
        }
    }
}

TEST(PointGrid, FindsTheBorderOfABoxAndOnlyWhatWasChosen)
{
    Points points(4, 3);
    points << 0, 0, 0, 1, 0, 0, 1, 1, 1, 2, 2, 2;
    const PointGrid grid(points, {1, 2, 3}, 0.7);
    EXPECT_EQ(found_in(grid, {0, 0, 0}, {1, 1, 1}), (VertexIds{1, 2}));
    EXPECT_EQ(found_in(PointGrid(Points(0, 3), 1.0), {0, 0, 0}, {1, 1, 1}), VertexIds{});
}

TEST(PointGrid, ABoxOfAnySizeIsAnsweredAtOnce)
{
    Points points(4, 3);
    points << 0, 0, 0, 1, 0, 0, 1, 1, 1, 2e29, 2, 2;
    const PointGrid grid(points, 0.7);
    const Vector3 far = Vector3::Constant(1e30);
    EXPECT_EQ(found_in(grid, -far, far), (VertexIds{0, 1, 2, 3}));
    EXPECT_EQ(found_in(grid, Vector3(0.5, -1e30, -1e30), far), (VertexIds{1, 2, 3}));
    EXPECT_EQ(found_in(grid, 0.5 * far, far), VertexIds{});
}

}  // namespace
}  // namespace sheetmorph::mesh

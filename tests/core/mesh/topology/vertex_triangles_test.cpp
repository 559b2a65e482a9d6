// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/vertex_triangles.h"

#include "shapes.h"

#include <gmock/gmock.h>

namespace sheetmorph::mesh
{
namespace
{

using testing::ElementsAre;

std::vector<int> listed(VertexTriangles::Range range)
{
    return {range.begin(), range.end()};
}

TEST(VertexTriangles, AreThoseThatHaveTheVertexAscending)
{
    Points points = shapes::grid(2, 1, 2.0, 1.0).points();
    points.conservativeResize(7, 3);
    points.row(6).setZero();
    Triangles triangles(4, 3);
    triangles << 1, 4, 3, 0, 1, 3, 2, 4, 1, 5, 5, 2;
    const VertexTriangles around(TriangleMesh(points, triangles));
    EXPECT_THAT(listed(around.at(1)), ElementsAre(0, 1, 2));
    EXPECT_THAT(listed(around.at(0)), ElementsAre(1));
    EXPECT_THAT(listed(around.at(5)), ElementsAre(3, 3));
    EXPECT_TRUE(around.at(6).is_empty());
    EXPECT_THAT(around.around({5, 2, 5}), ElementsAre(2, 3));
    EXPECT_THAT(around.around({6}), ElementsAre());
}

}  // namespace
}  // namespace sheetmorph::mesh

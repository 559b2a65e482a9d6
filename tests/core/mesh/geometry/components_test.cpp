// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/components.h"

#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{
namespace
{

// Two triangles apart, a lone vertex, and a triangle that repeats a vertex.
TriangleMesh two_islands()
{
    Points points = Points::Random(9, 3);
    Triangles triangles(3, 3);
    triangles << 4, 5, 6, 0, 1, 2, 7, 7, 8;
    return TriangleMesh(points, triangles);
}

TEST(Components, AreNumberedByTheirSmallestVertex)
{
    const Components found = connected_components(two_islands());
    EXPECT_EQ(found.count, 2);
    EXPECT_EQ(found.vertices(0), VertexIds({0, 1, 2}));
    EXPECT_EQ(found.vertices(1), VertexIds({4, 5, 6}));
}

TEST(Components, VerticesOfNoRealTriangleBelongToNone)
{
    const Components found = connected_components(two_islands());
    for (const std::size_t lone : {3, 7, 8})
        EXPECT_EQ(found.label[lone], Components::unused);
}

TEST(Components, AFeatureAcrossTwoIslandsJoinsThem)
{
    EXPECT_EQ(connected_components(two_islands(), {{1, 5}}).count, 1);
}

TEST(Components, AClosedSurfaceIsOne)
{
    EXPECT_EQ(connected_components(shapes::torus(12, 8, 30.0, 10.0)).count, 1);
}

}  // namespace
}  // namespace sheetmorph::mesh

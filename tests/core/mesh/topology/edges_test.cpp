// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/edges.h"

#include "shapes.h"

#include <gtest/gtest.h>

namespace sheetmorph::mesh
{

namespace
{

// Two unit triangles over the edge 0-1, the second turned up out of the plane by an angle.
TriangleMesh hinge(double angle, bool is_turned_over)
{
    Points points(4, 3);
    points << 0, 0, 0, 1, 0, 0, 0.5, -1, 0, 0.5, std::cos(angle), std::sin(angle);
    Triangles triangles(2, 3);
    triangles << 0, 2, 1, 0, 1, 3;
    if (is_turned_over)
        std::swap(triangles(1, 1), triangles(1, 2));
    return TriangleMesh(points, triangles);
}

}  // namespace

TEST(Edges, OfAClosedSurfaceHaveTwoTrianglesEachInOppositeDirections)
{
    const EdgeTable table(shapes::torus(8, 6, 3, 1));
    EXPECT_EQ(table.count(), 3 * 48);
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const EdgeUses uses = table.uses(edge);
        ASSERT_EQ(uses.count(), 2);
        EXPECT_EQ(uses.first[0].from, uses.first[1].to);
        EXPECT_EQ(uses.first[0].to, uses.first[1].from);
    }
}

TEST(Edges, ASideLeadsToTheEdgeThatUsesIt)
{
    const TriangleMesh mesh = shapes::plate_with_holes().mesh;
    const EdgeTable table(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            bool is_found = false;
            for (const EdgeUse& use : table.uses(table.edge_of(t, k)))
                is_found = is_found || (use.triangle == t && use.from == mesh.triangles()(t, k));
            EXPECT_TRUE(is_found);
        }
}

TEST(Edges, OfDoubledTrianglesCountOnceAndOfOnesThatRepeatAVertexNever)
{
    Triangles triangles(4, 3);
    triangles << 0, 1, 2, 2, 1, 0, 1, 1, 3, 1, 3, 2;
    const EdgeTable table(TriangleMesh(Points::Random(4, 3), triangles));
    EXPECT_EQ(table.count(), 5);
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_GE(table.edge_of(0, k), 0);
        EXPECT_EQ(table.edge_of(1, k), -1);
        EXPECT_EQ(table.edge_of(2, k), -1);
    }
}

TEST(Edges, BendAngleIsTheAngleBetweenThePlanesInEitherOrientation)
{
    for (const double angle : {0.0, 0.3, 1.5, 3.0, shapes::pi})
        for (const bool is_turned_over : {false, true})
        {
            const TriangleMesh mesh = hinge(angle, is_turned_over);
            const EdgeTable table(mesh);
            ASSERT_EQ(table.uses(0).count(), 2);
            const EdgeUse* use = table.uses(0).begin();
            EXPECT_NEAR(bend_angle(mesh.points(), use[0], use[1]), angle, 1e-12);
            EXPECT_NEAR(bend_angle(mesh.points(), use[1], use[0]), angle, 1e-12);
        }
}

}  // namespace sheetmorph::mesh

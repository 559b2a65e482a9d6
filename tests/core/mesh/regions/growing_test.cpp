// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/regions/growing.h"

#include "sheetmorph/base/errors.h"
#include "shapes.h"

#include <gmock/gmock.h>

namespace sheetmorph::mesh
{

namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

double degrees(double angle)
{
    return angle * shapes::pi / 180.0;
}

// A strip of 6 x 4 cells along x, bent about its middle by an angle; its first 24 triangles of
// every row pair lie left of the crease.
TriangleMesh bent_strip(double angle)
{
    return shapes::mapped(shapes::grid(6, 4, 6, 4),
                          [=](const Vector3& p)
                          {
                              const double beyond = std::max(0.0, p.x() - 3.0);
                              return Vector3(std::min(p.x(), 3.0) + beyond * std::cos(angle), p.y(),
                                             beyond * std::sin(angle));
                          });
}

TriangleMesh with_every_third_turned_over(const TriangleMesh& mesh)
{
    Triangles triangles = mesh.triangles();
    for (int t = 0; t < triangles.rows(); t += 3)
        std::swap(triangles(t, 1), triangles(t, 2));
    return TriangleMesh(mesh.points(), triangles);
}

}  // namespace

TEST(Growing, ByOneRingTakesTheTrianglesAround)
{
    const TriangleMesh mesh = shapes::grid(4, 4, 4, 4);
    EXPECT_THAT(grow_rings(mesh, {12}, 1), SizeIs(9));
    EXPECT_THAT(grow_rings(mesh, {12, 12}, 0), ElementsAre(12));
    EXPECT_THAT(grow_rings(mesh, {12}, 1000), SizeIs(25));
    EXPECT_THAT(grow_rings(mesh, {}, 3), IsEmpty());
}

TEST(Growing, ShrinkingUndoesGrowingOnAPlate)
{
    const auto plate = shapes::plate_with_holes();
    const VertexIds grown = grow_rings(plate.mesh, plate.rims[1], 2);
    VertexIds rim = plate.rims[1];
    std::sort(rim.begin(), rim.end());
    EXPECT_THAT(grown, SizeIs(3 * 32));
    EXPECT_EQ(shrink_rings(plate.mesh, grown, 2), rim);
}

TEST(Growing, ShrinkingLeavesTheBorderOfTheMeshAlone)
{
    const TriangleMesh mesh = shapes::grid(3, 3, 3, 3);
    VertexIds all = grow_rings(mesh, {0}, 100);
    EXPECT_EQ(shrink_rings(mesh, all, 5), all);
    EXPECT_THAT(shrink_rings(mesh, {0, 1, 4, 5}, 1), ElementsAre(0));
}

TEST(Growing, StopsAtACreaseAndPassesABlunterOne)
{
    const TriangleMesh strip = bent_strip(degrees(40));
    EXPECT_THAT(grow_to_creases(strip, 0, degrees(30)), SizeIs(24));
    EXPECT_THAT(grow_to_creases(strip, 0, degrees(41)), SizeIs(48));
}

TEST(Growing, StopsAtAFoldThatLiesOnTheSheet)
{
    EXPECT_THAT(grow_to_creases(bent_strip(degrees(175)), 0, degrees(30)), SizeIs(24));
}

TEST(Growing, TakesOneFaceOfABoxWithInconsistentTriangles)
{
    const TriangleMesh box = with_every_third_turned_over(shapes::box(4, {3, 4, 5}));
    for (int face = 0; face < 6; ++face)
    {
        const std::vector<int> grown = grow_to_creases(box, 32 * face + 7, degrees(20));
        ASSERT_THAT(grown, SizeIs(32));
        EXPECT_EQ(grown.front(), 32 * face);
        EXPECT_EQ(grown.back(), 32 * face + 31);
    }
}

TEST(Growing, FollowsARoundedSurfaceAllTheWay)
{
    const TriangleMesh pipe = shapes::half_pipe(24, 10, 10, 40);
    EXPECT_THAT(grow_to_creases(pipe, 0, degrees(10)), SizeIs(pipe.triangle_count()));
}

TEST(Growing, DoesNotLeakAcrossACreaseThroughASliver)
{
    Points points(6,
                  3);  // two unit triangles at a right angle; the edge 1-2 is doubled by a sliver
    points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0.5, 0, 1, 0, 1, 1, 1, 1;
    Triangles triangles(4, 3);
    triangles << 0, 1, 2, 1, 3, 2, 1, 4, 3, 3, 4, 2;
    const TriangleMesh mesh(points, triangles);
    EXPECT_THAT(grow_to_creases(mesh, 0, degrees(60)), ElementsAre(0, 1));
    EXPECT_THAT(grow_to_creases(mesh, 0, degrees(95)), ElementsAre(0, 1, 2, 3));
}

TEST(Growing, ConnectedTrianglesAreThoseOfOnePiece)
{
    const TriangleMesh one = shapes::grid(2, 2, 2, 2);
    const TriangleMesh far = shapes::mapped(one, [](Vector3 p) { return Vector3(p.array() + 9); });
    const TriangleMesh both = shapes::welded({one, far});
    EXPECT_THAT(connected_triangles(both, 3), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
    EXPECT_THAT(connected_triangles(both, 12), ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
}

TEST(Growing, TrianglesAndVerticesConvertIntoEachOther)
{
    const TriangleMesh mesh = shapes::grid(3, 1, 3, 1);
    EXPECT_THAT(vertices_of_triangles(mesh, {0, 1, 1}), ElementsAre(0, 1, 4, 5));
    EXPECT_THAT(triangles_with_all_vertices(mesh, {0, 1, 4, 5, 2}), ElementsAre(0, 1, 2));
}

TEST(Growing, IdsOutsideTheMeshAreRefusedByName)
{
    const TriangleMesh mesh = shapes::grid(3, 1, 3, 1);
    EXPECT_THROW(grow_rings(mesh, {0}, -1), InvalidInput);
    EXPECT_THROW(shrink_rings(mesh, {8}, 1), InvalidInput);
    EXPECT_THROW(grow_to_creases(mesh, 6, 1.0), InvalidInput);
    EXPECT_THROW(grow_to_creases(mesh, 0, std::nan("")), InvalidInput);
    EXPECT_THROW(connected_triangles(mesh, -1), InvalidInput);
    EXPECT_THROW(vertices_of_triangles(mesh, {-7}), InvalidInput);
    try
    {
        grow_rings(mesh, {3, 77}, 1);
        FAIL() << "a vertex that does not exist was accepted";
    }
    catch (const InvalidInput& error)
    {
        EXPECT_THAT(error.what(), testing::HasSubstr("77"));
    }
}

}  // namespace sheetmorph::mesh

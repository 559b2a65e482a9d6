// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/boundary.h"

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
using testing::UnorderedElementsAreArray;

TriangleMesh with_triangles(const Points& points, const std::vector<Eigen::RowVector3i>& rows)
{
    Triangles triangles(rows.size(), 3);
    for (std::size_t t = 0; t < rows.size(); ++t)
        triangles.row(t) = rows[t];
    return TriangleMesh(points, triangles);
}

TriangleMesh without(const TriangleMesh& mesh, const std::vector<int>& dropped)
{
    std::vector<Eigen::RowVector3i> rows;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (std::find(dropped.begin(), dropped.end(), t) == dropped.end())
            rows.push_back(mesh.triangles().row(t));
    return with_triangles(mesh.points(), rows);
}

TriangleMesh with_extra(const TriangleMesh& mesh, const std::vector<Eigen::RowVector3i>& extra)
{
    std::vector<Eigen::RowVector3i> rows;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        rows.push_back(mesh.triangles().row(t));
    rows.insert(rows.end(), extra.begin(), extra.end());
    return with_triangles(mesh.points(), rows);
}

// Two crossing cells of a 4 x 4 grid left out: both holes have vertex 12, the middle one.
TriangleMesh holes_that_touch()
{
    return without(shapes::grid(4, 4, 4, 4), {2 * 5, 2 * 5 + 1, 2 * 10, 2 * 10 + 1});
}

// A flange of 2 x 2 cells with a web of 2 x 1 cells standing on its middle row (vertices 3, 4, 5).
TriangleMesh t_beam()
{
    const TriangleMesh flange = shapes::grid(2, 2, 2, 2);
    Points points(12, 3);
    points << flange.points(), Eigen::RowVector3d(0, 1, 1), Eigen::RowVector3d(1, 1, 1),
        Eigen::RowVector3d(2, 1, 1);
    return with_extra(TriangleMesh(points, flange.triangles()),
                      {{3, 4, 10}, {3, 10, 9}, {4, 5, 11}, {4, 11, 10}});
}

}  // namespace

TEST(Boundary, OfAClosedSurfaceIsEmpty)
{
    EXPECT_THAT(boundary_loops(shapes::box(3, {1, 2, 3})), IsEmpty());
    EXPECT_THAT(boundary_loops(shapes::sphere(2, 1)), IsEmpty());
    EXPECT_THAT(boundary_edges(shapes::torus(8, 6, 3, 1)), IsEmpty());
}

TEST(Boundary, LoopsOfAPlateWithThreeHolesAreFourAndContainTheRims)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const auto loops = boundary_loops(plate.mesh);
    ASSERT_THAT(loops, SizeIs(4));
    for (const VertexIds& rim : plate.rims)
        EXPECT_THAT(boundary_loop_at(plate.mesh, rim[3]), UnorderedElementsAreArray(rim));
}

TEST(Boundary, LoopsRunAlongTheRimWithTheSheetOnTheirLeft)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const VertexIds rim = boundary_loop_at(plate.mesh, plate.rims[0][5]);
    VertexIds clockwise(plate.rims[0].rbegin(), plate.rims[0].rend());
    std::rotate(clockwise.begin(), std::find(clockwise.begin(), clockwise.end(), rim[0]),
                clockwise.end());
    EXPECT_EQ(rim, clockwise);
    EXPECT_THAT(boundary_loop_at(shapes::grid(1, 1, 1, 1), 2), ElementsAre(0, 1, 3, 2));
}

TEST(Boundary, ALoopStartsAtItsSmallestVertexAndLoopsComeInThatOrder)
{
    const auto shape = shapes::renumbered(shapes::plate_with_holes().mesh, 7);
    const auto loops = boundary_loops(shape.mesh);
    ASSERT_THAT(loops, SizeIs(4));
    EXPECT_TRUE(std::is_sorted(loops.begin(), loops.end()));
    for (const VertexIds& loop : loops)
        EXPECT_EQ(loop.front(), *std::min_element(loop.begin(), loop.end()));
}

TEST(Boundary, HolesThatMeetInAVertexAreSeparateLoops)
{
    const auto loops = boundary_loops(holes_that_touch());
    ASSERT_THAT(loops, SizeIs(3));
    EXPECT_THAT(loops[1], UnorderedElementsAreArray({6, 7, 11, 12}));
    EXPECT_THAT(loops[2], UnorderedElementsAreArray({12, 13, 17, 18}));
}

TEST(Boundary, AHoleThatTouchesTheBorderIsFoundInsteadOfTheBorder)
{
    const TriangleMesh mesh = without(shapes::grid(4, 4, 4, 4), {0, 1, 2 * 5, 2 * 5 + 1});
    EXPECT_THAT(boundary_loops(mesh), SizeIs(2));
    EXPECT_THAT(boundary_loop_at(mesh, 6), UnorderedElementsAreArray({6, 7, 11, 12}));
    EXPECT_THAT(boundary_loop_at(mesh, 24), testing::Contains(6));
}

TEST(Boundary, PatchesThatMeetInAVertexKeepTheirOwnBorders)
{
    const TriangleMesh square = shapes::grid(2, 2, 2, 2);
    const auto loops = boundary_loops(without(square, {2, 3, 4, 5}));
    ASSERT_THAT(loops, SizeIs(2));
    EXPECT_THAT(loops[0], ElementsAre(0, 1, 4, 3));
    EXPECT_THAT(loops[1], ElementsAre(4, 5, 8, 7));
}

TEST(Boundary, AFlangeKeepsItsBorderWhereAWebStandsOnIt)
{
    const TriangleMesh beam = t_beam();
    EXPECT_THAT(boundary_edges(beam), SizeIs(8 + 4));
    const auto loops = boundary_loops(beam);
    ASSERT_THAT(loops, SizeIs(1));
    EXPECT_THAT(loops[0], ElementsAre(0, 1, 2, 5, 8, 7, 6, 3));
    EXPECT_THROW(boundary_loop_at(beam, 10), InvalidInput);
}

TEST(Boundary, DoesNotDependOnTheOrientationOfTriangles)
{
    const TriangleMesh mesh = shapes::plate_with_holes().mesh;
    Triangles mixed = mesh.triangles();
    for (int t = 0; t < mixed.rows(); t += 3)
        std::swap(mixed(t, 0), mixed(t, 1));
    const auto loops = boundary_loops(TriangleMesh(mesh.points(), mixed));
    const auto expected = boundary_loops(mesh);
    ASSERT_THAT(loops, SizeIs(expected.size()));
    for (std::size_t k = 0; k < loops.size(); ++k)
        EXPECT_THAT(loops[k], UnorderedElementsAreArray(expected[k]));
}

TEST(Boundary, DoubledAndDegenerateTrianglesChangeNothing)
{
    const TriangleMesh mesh = shapes::grid(3, 3, 3, 3);
    const Eigen::RowVector3i first = mesh.triangles().row(0);
    const TriangleMesh dirty =
        with_extra(mesh, {first, {first(1), first(0), first(2)}, {5, 5, 6}, {2, 2, 2}, {0, 15, 0}});
    EXPECT_EQ(boundary_loops(dirty), boundary_loops(mesh));
    EXPECT_THAT(boundary_loops(TriangleMesh()), IsEmpty());
}

TEST(Boundary, ATriangleSoupGivesOneLoopATriangle)
{
    EXPECT_THAT(
        boundary_loops(with_triangles(shapes::grid(2, 1, 2, 1).points(), {{0, 1, 3}, {2, 5, 4}})),
        SizeIs(2));
}

TEST(Boundary, AVertexInsideOrOutsideTheMeshIsRefusedByName)
{
    const TriangleMesh mesh = shapes::grid(2, 2, 2, 2);
    EXPECT_THROW(boundary_loop_at(mesh, -1), InvalidInput);
    EXPECT_THROW(boundary_loop_at(mesh, 9), InvalidInput);
    try
    {
        boundary_loop_at(mesh, 4);
        FAIL() << "an inner vertex was accepted";
    }
    catch (const InvalidInput& error)
    {
        EXPECT_THAT(error.what(), testing::HasSubstr("vertex 4"));
    }
}

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/quality/quality.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rigid_motion.h"
#include "shapes.h"

#include <gmock/gmock.h>

namespace sheetmorph::mesh
{

namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

TriangleMesh one_triangle(const Eigen::RowVector3d& tip)
{
    Points points(3, 3);
    points << 0, 0, 0, 2, 0, 0, tip;
    Triangles triangles(1, 3);
    triangles << 0, 1, 2;
    return TriangleMesh(points, triangles);
}

// The part of a flat sheet beyond x = 3 turned about that line by an angle.
Points folded(const TriangleMesh& sheet, double angle)
{
    return shapes::mapped(sheet,
                          [=](const Vector3& p)
                          {
                              const double beyond = std::max(0.0, p.x() - 3.0);
                              return Vector3(std::min(p.x(), 3.0) + beyond * std::cos(angle), p.y(),
                                             beyond * std::sin(angle));
                          })
        .points();
}

}  // namespace

TEST(Quality, OfAVertexIsTheSmallestCornerOfItsTriangles)
{
    Points points(5, 3);
    points << 0, 0, 0, 2, 0, 0, 1, std::sqrt(3.0), 0, 1, -1, 0, 9, 9, 9;
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 0, 3, 1;
    const Eigen::VectorXd found = vertex_quality(TriangleMesh(points, triangles));
    EXPECT_NEAR(found(2), 60.0, 1e-12);
    for (const int vertex : {0, 1, 3})
        EXPECT_NEAR(found(vertex), 45.0, 1e-12);
    EXPECT_NEAR(found(4), 60.0, 1e-12);
    EXPECT_EQ(vertex_quality(one_triangle({1, 0, 0}))(0), 0.0);
}

TEST(Quality, OfAnEquilateralTriangleIsPerfect)
{
    const MeshQuality found = quality(one_triangle({1, std::sqrt(3.0), 0}));
    EXPECT_NEAR(found.worst_angle_degrees, 60.0, 1e-12);
    EXPECT_NEAR(found.worst_aspect, 1.0, 1e-12);
    EXPECT_EQ(found.degenerate, 0);
}

TEST(Quality, OfAFlatTriangleIsItsAngleAndItsAspect)
{
    const MeshQuality found = quality(one_triangle({1, 0.1, 0}));
    EXPECT_NEAR(found.worst_angle_degrees, std::atan(0.1) * 180.0 / shapes::pi, 1e-12);
    EXPECT_NEAR(found.worst_aspect, std::sqrt(0.75) * 20.0, 1e-11);
}

TEST(Quality, CountsDegenerateTrianglesAndLeavesThemOut)
{
    const TriangleMesh grid = shapes::grid(2, 2, 2, 2);
    Triangles triangles(grid.triangle_count() + 2, 3);
    triangles << grid.triangles(), Eigen::RowVector3i(0, 1, 2), Eigen::RowVector3i(4, 4, 5);
    const MeshQuality found = quality(TriangleMesh(grid.points(), triangles));
    EXPECT_EQ(found.degenerate, 2);
    EXPECT_NEAR(found.worst_angle_degrees, 45.0, 1e-12);
    EXPECT_EQ(quality(TriangleMesh()).degenerate, 0);
}

TEST(Quality, ARigidMotionFlipsAndStretchesNothing)
{
    RigidMotion motion;
    motion.translation = Vector3(100, -50, 7);
    for (const Vector3& log : {Vector3(0.5 * shapes::pi, 0, 0), Vector3(0.9, 0.8, -0.4)})
    {
        motion.rotation_log = log;
        for (const TriangleMesh& mesh :
             {shapes::plate_with_holes().mesh, shapes::box(3, {1, 2, 3}), shapes::sphere(2, 4)})
        {
            const QualityChange change = compare_quality(mesh, motion.apply(mesh.points()));
            EXPECT_THAT(change.flipped, IsEmpty());
            EXPECT_NEAR(change.largest_stretch, 1.0, 1e-12);
            EXPECT_NEAR(change.smallest_stretch, 1.0, 1e-12);
        }
    }
}

TEST(Quality, ASheetFoldedOntoItselfIsFlippedAlongTheFold)
{
    const TriangleMesh sheet = shapes::grid(6, 1, 6, 1);
    EXPECT_THAT(compare_quality(sheet, folded(sheet, 2.5)).flipped, IsEmpty());
    EXPECT_THAT(compare_quality(sheet, folded(sheet, 3.0)).flipped, ElementsAre(4, 6));
}

TEST(Quality, AHemThatWasFoldedAtRestIsNotFlipped)
{
    const TriangleMesh sheet = shapes::grid(6, 1, 6, 1);
    const TriangleMesh hem(folded(sheet, 2.5), sheet.triangles());
    EXPECT_THAT(compare_quality(hem, folded(sheet, 2.7)).flipped, IsEmpty());
    EXPECT_THAT(compare_quality(hem, folded(sheet, 3.1)).flipped, ElementsAre(4, 6));
}

TEST(Quality, AVertexPulledAcrossItsNeighboursFlipsTriangles)
{
    const TriangleMesh sheet = shapes::grid(4, 4, 4, 4);
    Points points = sheet.points();
    points.row(12) << 3.5, 2.2, 0.0;
    EXPECT_FALSE(compare_quality(sheet, points).flipped.empty());
    points.row(12) << 2.4, 2.2, 0.0;
    EXPECT_THAT(compare_quality(sheet, points).flipped, IsEmpty());
}

TEST(Quality, FlippedDoesNotDependOnOrientation)
{
    const TriangleMesh sheet = shapes::grid(6, 4, 6, 4);
    Triangles mixed = sheet.triangles();
    for (int t = 0; t < mixed.rows(); t += 3)
        std::swap(mixed(t, 0), mixed(t, 1));
    const TriangleMesh other(sheet.points(), mixed);
    EXPECT_EQ(compare_quality(sheet, folded(sheet, 3.0)).flipped,
              compare_quality(other, folded(sheet, 3.0)).flipped);
}

TEST(Quality, StretchIsTheRatioOfEdgeLengths)
{
    const TriangleMesh sheet = shapes::grid(3, 3, 3, 3);
    const Points wide = sheet.points() * Eigen::Vector3d(2, 0.5, 1).asDiagonal();
    const QualityChange change = compare_quality(sheet, wide);
    EXPECT_NEAR(change.largest_stretch, 2.0, 1e-14);
    EXPECT_NEAR(change.smallest_stretch, 0.5, 1e-14);
}

TEST(Quality, AnotherNumberOfPointsOrNanIsRefused)
{
    const TriangleMesh sheet = shapes::grid(3, 3, 3, 3);
    EXPECT_THROW(compare_quality(sheet, Points::Zero(3, 3)), InvalidInput);
    Points points = sheet.points();
    points(2, 1) = std::nan("");
    EXPECT_THROW(compare_quality(sheet, points), InvalidInput);
}

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/oriented_box.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"
#include "shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sheetmorph::volume
{

namespace
{

const Matrix3 turn = rotation_from_log(Vector3(0.3, -0.5, 0.2));

Points turned(const Points& points)
{
    return points * turn.transpose();
}

// The box as a set: what its faces are, whatever the order and sign of its axes.
Matrix3 spread(const OrientedBox& box)
{
    const Matrix3 half = box.axes * box.half_extents.asDiagonal();
    return half * half.transpose();
}

OrientedBox box_of(const Points& points, const Matrix3& frame)
{
    return oriented_box(points, principal_axes(points, {}, frame));
}

TEST(OrientedBoxTest, HoldsEveryPoint)
{
    const Points points = turned(shapes::half_pipe(8, 5, 10.0, 37.0).points());
    const OrientedBox box = box_of(points, Matrix3::Identity());
    const Points local = (points.rowwise() - box.centre.transpose()) * box.axes;
    for (int a = 0; a < 3; ++a)
        EXPECT_LT(local.col(a).cwiseAbs().maxCoeff(), box.half_extents(a));
    EXPECT_NEAR(box.axes.determinant(), 1.0, 1e-12);
}

// Without a margin a point lies on every side, and none beyond.
TEST(OrientedBoxTest, EverySideTouchesAPoint)
{
    std::srand(2);
    const Points points = (Points::Random(40, 3) * Vector3(9.0, 5.0, 3.0).asDiagonal()).rowwise()
                          + Eigen::RowVector3d(30.0, -80.0, 10.0);
    const OrientedBox box = oriented_box(points, turn, {0.0, 0.0, 1.0});
    const Points local = (points.rowwise() - box.centre.transpose()) * box.axes;
    for (int a = 0; a < 3; ++a)
    {
        EXPECT_NEAR(local.col(a).maxCoeff(), box.half_extents(a), 1e-12);
        EXPECT_NEAR(local.col(a).minCoeff(), -box.half_extents(a), 1e-12);
    }
}

TEST(OrientedBoxTest, AFlatSetGetsThicknessAndSaysHowMuch)
{
    const Points points = shapes::grid(6, 3, 60.0, 20.0).points();
    const OrientedBox box =
        oriented_box(points, principal_axes(points, {}, Matrix3::Identity()), {0.1, 0.25, 1.0});
    EXPECT_NEAR(box.half_extents(0), 33.0, 1e-12);
    EXPECT_NEAR(box.half_extents(1), 13.0, 1e-12);
    EXPECT_NEAR(box.half_extents(2), 10.5, 1e-12);
    EXPECT_NEAR(box.widened_by(0), 3.0, 1e-12);
    EXPECT_NEAR(box.widened_by(2), 10.5, 1e-12);
}

TEST(OrientedBoxTest, AStraightSetTakesTheOtherAxesFromTheFrame)
{
    Points points(5, 3);
    for (int i = 0; i < 5; ++i)
        points.row(i) << 2.0 * i, 0.0, 0.0;
    const Matrix3 axes = principal_axes(points, {}, Matrix3::Identity());
    EXPECT_LT((axes - Matrix3::Identity()).norm(), 1e-12);
    const Matrix3 turned_axes = principal_axes(turned(points), {}, turn);
    EXPECT_LT((turned_axes - turn).norm(), 1e-9);
}

TEST(OrientedBoxTest, ASinglePointGetsTheGivenSize)
{
    Points point(1, 3);
    point << 5.0, 6.0, 7.0;
    const OrientedBox box = oriented_box(point, principal_axes(point, {}, turn), {0.1, 0.25, 3.0});
    EXPECT_TRUE(box.half_extents == Vector3::Constant(3.0));
    EXPECT_TRUE(box.widened_by == Vector3::Constant(3.0));
    EXPECT_TRUE(box.centre == Vector3(5.0, 6.0, 7.0));
    EXPECT_LT((box.axes - turn).norm(), 1e-12);
}

TEST(OrientedBoxTest, AWasherTakesItsAxesFromTheFrameSoThatATurnedModelGivesTheTurnedBox)
{
    const Points points = shapes::annulus(24, 3, 5.0, 10.0).points();
    const Matrix3 box = spread(box_of(points, Matrix3::Identity()));
    const Matrix3 turned_box = spread(box_of(turned(points), turn));
    EXPECT_LT((turned_box - turn * box * turn.transpose()).norm(), 1e-9 * box.norm());
}

TEST(OrientedBoxTest, TurnedMirroredAndScaledPointsGiveTheTurnedMirroredAndScaledBox)
{
    Points points = shapes::half_pipe(8, 5, 10.0, 37.0).points();
    for (int i = 0; i < points.rows(); i += 3)
        points.row(i) *= 1.01;
    const Matrix3 box = spread(box_of(points, Matrix3::Identity()));
    const Matrix3 turned_box = spread(box_of(turned(points), turn));
    EXPECT_LT((turned_box - turn * box * turn.transpose()).norm(), 1e-11 * box.norm());
    const Matrix3 mirror = Vector3(-1.0, 1.0, 1.0).asDiagonal();
    const Matrix3 mirrored = spread(box_of(points * mirror, mirror));
    EXPECT_LT((mirrored - mirror * box * mirror).norm(), 1e-11 * box.norm());
    const Matrix3 metres = spread(box_of(1e-3 * points, Matrix3::Identity()));
    EXPECT_LT((metres - 1e-6 * box).norm(), 1e-11 * 1e-6 * box.norm());
}

TEST(OrientedBoxTest, NoPointsAndNegativeMarginsAreRefused)
{
    EXPECT_THROW(principal_axes(Points(0, 3), {}, turn), InvalidInput);
    EXPECT_THROW(oriented_box(Points::Zero(2, 3), turn, {-0.1, 0.25, 1.0}), InvalidInput);
}

}  // namespace

}  // namespace sheetmorph::volume

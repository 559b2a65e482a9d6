// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rigid_motion.h"

#include "sheetmorph/base/rotation.h"

#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

RigidMotion some_motion()
{
    return {{3.0, -7.0, 11.0}, rotation_log({1.0, 2.0, 3.0}, 2.2), {5.0, 0.0, -4.0}};
}

double worst(const Points& a, const Points& b)
{
    return (a - b).rowwise().norm().maxCoeff();
}

TEST(RigidMotion, NoMotionReturnsThePointBitForBit)
{
    const Vector3 point(0.1, 1e5 / 3.0, -7e-9);
    EXPECT_EQ(RigidMotion{}.apply(point), point);
}

TEST(RigidMotion, ThePivotMovesByTheTranslationAlone)
{
    const RigidMotion motion = some_motion();
    EXPECT_LT((motion.apply(motion.pivot) - motion.pivot - motion.translation).norm(), 1e-14);
}

TEST(RigidMotion, ManyPointsMoveAsEachAlone)
{
    const Points points = Points::Random(20, 3) * 100.0;
    const Points moved = some_motion().apply(points);
    for (int i = 0; i < points.rows(); ++i)
        EXPECT_LT((moved.row(i).transpose() - some_motion().apply(Vector3(points.row(i)))).norm(),
                  1e-12);
}

TEST(BestRigidMotion, FindsTheMotionOfAnyPointSet)
{
    const Points cloud = Points::Random(30, 3) * 50.0;
    Points flat = cloud;
    flat.col(2).setZero();
    for (const Points& from : {cloud, flat})
    {
        const RigidMotion motion = best_rigid_motion(from, some_motion().apply(from));
        EXPECT_LT(worst(motion.apply(from), some_motion().apply(from)), 1e-11);
    }
}

TEST(BestRigidMotion, AStraightRowTakesTheSmallestTurnAndAPointNone)
{
    Points row(4, 3);
    row << 0, 0, 0, 10, 0, 0, 20, 0, 0, 30, 0, 0;
    const RigidMotion quarter{{1, 2, 3}, rotation_log({0, 0, 1}, 1.5), {0, 0, 0}};
    const RigidMotion motion = best_rigid_motion(row, quarter.apply(row));
    EXPECT_LT(worst(motion.apply(row), quarter.apply(row)), 1e-12);
    EXPECT_NEAR(motion.rotation_log.norm(), 0.75, 1e-9);
    const Points point = row.topRows(1);
    const RigidMotion shift = best_rigid_motion(point, quarter.apply(point));
    EXPECT_TRUE(shift.rotation_log.isZero(0.0));
    EXPECT_LT(worst(shift.apply(point), quarter.apply(point)), 1e-12);
}

TEST(BestRigidMotion, WeightsDecideBetweenPointsThatDisagree)
{
    Points from(2, 3);
    from << 0, 0, 0, 0, 0, 0;
    Points to(2, 3);
    to << 1, 0, 0, 4, 0, 0;
    const RigidMotion motion = best_rigid_motion(from, to, Eigen::Vector2d(2.0, 1.0));
    EXPECT_NEAR(motion.translation.x(), 2.0, 1e-14);
}

TEST(BestRigidMotionNear, IsExactForPointsThatMoveAsToldAndForAnyOneOfThem)
{
    const Points cloud = Points::Random(30, 3) * 50.0;
    Points row = cloud;
    row.rightCols(2).setZero();
    for (const Points& from : {cloud, row, Points(cloud.topRows(1))})
    {
        const Points to = some_motion().apply(from);
        const RigidMotion motion = best_rigid_motion_near(from, to, some_motion().rotation_log);
        EXPECT_LT(worst(motion.apply(from), to), 1e-11);
        EXPECT_LT((motion.rotation_log - some_motion().rotation_log).norm(), 1e-9);
    }
}

TEST(BestRigidMotionNear, ARowThatIsNearlyStraightDoesNotTurnOver)
{
    Points row(20, 3);
    for (int i = 0; i < 20; ++i)
        row.row(i) << 3.5 * i, 0.0, 0.0;
    Points bent = row;  // the targets bow the other way, by a hair
    for (const double bow : {1e-7, 1e-5, 1e-3, 1e-1})
    {
        for (int i = 0; i < 20; ++i)
        {
            const double s = i / 19.0;
            row(i, 2) = bow * s * (1.0 - s);
            bent(i, 2) = -bow * s * (1.0 - s);
        }
        EXPECT_LT(best_rigid_motion_near(row, bent, Vector3::Zero()).rotation_log.norm(), 0.01);
    }
}

// Points without weight may be anywhere; heavier ones are nearer to their targets.
TEST(BestRigidMotion, WeightsDecideWhichPointsCount)
{
    const Points from = Points::Random(12, 3) * 30.0;
    Points to = some_motion().apply(from);
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(12);
    for (const int stray : {1, 4, 9})
    {
        to.row(stray) += Eigen::RowVector3d(40.0, -10.0 * stray, 5.0);
        weights(stray) = 0.0;
    }
    const RigidMotion best = best_rigid_motion(from, to, weights);
    for (const int kept : {0, 2, 3, 5, 11})
        EXPECT_LT((best.apply(Vector3(from.row(kept))) - to.row(kept).transpose()).norm(), 1e-11);
}

}  // namespace
}  // namespace sheetmorph

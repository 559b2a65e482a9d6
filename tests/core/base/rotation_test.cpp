// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rotation.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/Dense>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>

namespace sheetmorph
{
namespace
{

constexpr double pi = 3.14159265358979323846;

TEST(Rotation, TheLogarithmIsHalfTheAngleAlongTheAxis)
{
    const Vector3 log = rotation_log({0.0, 0.0, 7.0}, 1.5);
    EXPECT_LT((log - Vector3(0.0, 0.0, 0.75)).norm(), 1e-15);
    const Matrix3 expected = Eigen::AngleAxisd(1.5, Vector3::UnitZ()).toRotationMatrix();
    EXPECT_LT((rotation_from_log(log) - expected).norm(), 1e-15);
}

TEST(Rotation, AnglesBeyondATurnAreKept)
{
    EXPECT_NEAR(rotation_log({1.0, 1.0, 0.0}, 7.0 * pi).norm(), 3.5 * pi, 1e-12);
}

TEST(Rotation, NoTurnNeedsNoAxisAndIsExactlyTheIdentity)
{
    EXPECT_EQ(rotation_log(Vector3::Zero(), 0.0), Vector3(Vector3::Zero()));
    EXPECT_EQ(rotation_from_log(Vector3::Zero()), Matrix3(Matrix3::Identity()));
}

TEST(Rotation, AZeroAxisOrANumberThatIsNoneIsBadInput)
{
    EXPECT_THROW(rotation_log(Vector3::Zero(), 1.0), InvalidInput);
    EXPECT_THROW(rotation_log(Vector3::UnitX(), std::numeric_limits<double>::infinity()),
                 InvalidInput);
}

TEST(Rotation, LogAndExpAreInverseToEachOtherUpToAHalfTurn)
{
    for (const double angle : {1e-12, 1e-3, 1.0, 3.0, pi - 1e-9})
    {
        const Vector3 log = rotation_log({0.3, -0.5, 0.8}, angle);
        EXPECT_LT((log_from_rotation(rotation_from_log(log)) - log).norm(), 1e-9 * angle + 1e-15);
    }
}

TEST(Rotation, TheNearestBranchFollowsAReferenceThroughManyTurns)
{
    const Vector3 axis = Vector3(1.0, 2.0, -0.5).normalized();
    for (double angle = -15.0; angle < 15.0; angle += 0.37)
    {
        const Vector3 log = rotation_log(axis, angle);
        const Vector3 near = rotation_log(axis, angle + 0.9);
        const Vector3 found = nearest_branch(log_from_rotation(rotation_from_log(log)), near);
        EXPECT_LT((found - log).norm(), 1e-9) << angle;
    }
    const Vector3 whole_turns = rotation_log(axis, 4.0 * pi);
    EXPECT_LT((nearest_branch(Vector3::Zero(), whole_turns) - whole_turns).norm(), 1e-12);
}

TEST(Rotation, TheNearestRotationIgnoresStretchAndNeverMirrors)
{
    const Matrix3 rotation = rotation_from_log({0.2, 0.4, -0.3});
    const Matrix3 stretch = Vector3(1.0, 2.0, 0.5).asDiagonal();
    EXPECT_LT((nearest_rotation(rotation * stretch) - rotation).norm(), 1e-12);
    EXPECT_GT(nearest_rotation(-Matrix3::Identity())
                  .col(0)
                  .cross(Vector3(nearest_rotation(-Matrix3::Identity()).col(1)))
                  .dot(nearest_rotation(-Matrix3::Identity()).col(2)),
              0.99);
}

// Also where the matrix mirrors: no rotation out of many is nearer.
TEST(Rotation, NoRotationIsNearerThanTheNearestOne)
{
    std::srand(5);
    for (int round = 0; round < 40; ++round)
    {
        const Matrix3 matrix = Matrix3::Random();
        const Matrix3 found = nearest_rotation(matrix);
        EXPECT_LT((found * found.transpose() - Matrix3::Identity()).norm(), 1e-12);
        EXPECT_NEAR(found.determinant(), 1.0, 1e-12);
        for (int other = 0; other < 100; ++other)
        {
            const Matrix3 step = rotation_from_log(Vector3::Random() * (other < 50 ? 0.01 : 1.5));
            EXPECT_LE((matrix - found).norm(), (matrix - step * found).norm() + 1e-12);
        }
    }
}

}  // namespace
}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/local_rotations.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/rotations/rotation_batch.h"
#include "volume/link_scene.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace sheetmorph::volume
{

using namespace mesh;

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;

Points repeated(const Vector3& log, Eigen::Index count)
{
    return log.transpose().replicate(count, 1);
}

TEST(LocalRotationsTest, RestGivesTheIdentityExactly)
{
    const TriangleMesh mesh = shapes::half_pipe(6, 4, 10.0, 30.0);
    const LocalRotationMeter meter(mesh, scene::all_vertices(mesh));
    const LocalRotations found = meter.measure(mesh.points(), Points::Zero(mesh.vertex_count(), 3));
    EXPECT_TRUE(found.logs.isZero(0.0));
    for (const Matrix3& matrix : found.matrices)
        EXPECT_TRUE(matrix == Matrix3::Identity());
}

TEST(LocalRotationsTest, ATurnBeyondTwoWholeTurnsIsFollowed)
{
    const TriangleMesh mesh = shapes::grid(4, 3, 40.0, 20.0);
    const LocalRotationMeter meter(mesh, scene::all_vertices(mesh));
    for (double degrees : {30.0, 179.0, 270.0, 359.0, 360.0, 400.0, 725.0})
    {
        const Vector3 log = rotation_log(Vector3(1.0, 2.0, -1.0), degrees * degree);
        const RigidMotion motion{Vector3(1, 2, 3), log, Vector3(4, 5, 6)};
        const Points nearly = repeated(0.99 * log, mesh.vertex_count());
        const LocalRotations found = meter.measure(motion.apply(mesh.points()), nearly);
        EXPECT_LT((found.logs.rowwise() - log.transpose()).cwiseAbs().maxCoeff(), 1e-10) << degrees;
    }
}

TEST(LocalRotationsTest, AStretchedFlatSheetDoesNotTurn)
{
    const TriangleMesh mesh = shapes::jittered_grid(6, 5, 1.0, 3);
    const LocalRotationMeter meter(mesh, scene::all_vertices(mesh));
    const Points stretched = mesh.points() * Vector3(1.5, 0.7, 1.0).asDiagonal();
    const LocalRotations found = meter.measure(stretched, Points::Zero(mesh.vertex_count(), 3));
    EXPECT_LT(found.logs.cwiseAbs().maxCoeff(), 1e-13);
}

// A flat ring under any map of space: its edges turn by the map, its normal by that of its plane.
TEST(LocalRotationsTest, AFlatRingInAnyPlaneTurnsByThePolarFactorOfItsMap)
{
    std::srand(9);
    for (int round = 0; round < 30; ++round)
    {
        const Matrix3 frame = rotation_from_log(2.0 * Vector3::Random());
        Points rest = shapes::jittered_grid(4, 4, 1.0, 3).points();
        const Triangles triangles = shapes::jittered_grid(4, 4, 1.0, 3).triangles();
        rest = (rest * frame.transpose()).eval();
        const Matrix3 map = rotation_from_log(0.5 * Vector3::Random())
                            * (Matrix3::Identity() + 0.3 * Matrix3::Random());
        const Vector3 normal = frame.col(2);
        const Vector3 now = (map * frame.col(0)).cross(map * frame.col(1)).normalized();
        const Matrix3 expected = polar_rotation(
            map * (Matrix3::Identity() - normal * normal.transpose()) + now * normal.transpose());
        const TriangleMesh mesh(rest, triangles);
        const LocalRotationMeter meter(mesh, scene::all_vertices(mesh));
        const LocalRotations found =
            meter.measure(rest * map.transpose(), Points::Zero(mesh.vertex_count(), 3));
        for (const Matrix3& rotation : found.matrices)
            EXPECT_LT((rotation - expected).norm(), 1e-9) << round;
    }
}

TEST(LocalRotationsTest, VerticesWithoutAUsableRingTakeTheReference)
{
    Points points(5, 3);
    points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 9, 9, 9;
    Triangles triangles(1, 3);
    triangles << 0, 1, 2;
    const LocalRotationMeter meter(TriangleMesh(points, triangles), {0, 4});
    const Points references = repeated(Vector3(0.1, 0.2, 0.3), 2);
    const LocalRotations found = meter.measure(2.0 * points, references);
    EXPECT_TRUE(found.logs == references);
}

TEST(LocalRotationsTest, BadlyOrientedTrianglesDoNotMatter)
{
    const TriangleMesh good = shapes::grid(4, 4, 4.0, 4.0);
    Triangles flipped = good.triangles();
    for (Eigen::Index t = 0; t < flipped.rows(); t += 2)
        flipped.row(t).reverseInPlace();
    const TriangleMesh bad(good.points(), flipped);
    const Vector3 log = rotation_log(Vector3(0.0, 1.0, 1.0), 70.0 * degree);
    const Points turned = RigidMotion{Vector3::Zero(), log, Vector3::Zero()}.apply(bad.points());
    const LocalRotationMeter meter(bad, scene::all_vertices(bad));
    const LocalRotations found = meter.measure(turned, Points::Zero(bad.vertex_count(), 3));
    EXPECT_LT((found.logs.rowwise() - log.transpose()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LocalRotationsTest, UnknownVerticesAreNamed)
{
    EXPECT_THROW(LocalRotationMeter(shapes::grid(2, 2, 1.0, 1.0), {0, 99}), InvalidInput);
}

TEST(LogNearTest, IsALogarithmOfRotationsAwayFromWholeTurns)
{
    for (double degrees : {10.0, 120.0, 200.0, 220.0})
    {
        const Vector3 reference = rotation_log(Vector3(1.0, -1.0, 0.5), degrees * degree);
        const Matrix3 rotation =
            rotation_from_log(Vector3(0.05, 0.04, -0.06)) * rotation_from_log(reference);
        const Vector3 log = log_near(rotation, reference);
        EXPECT_LT((rotation_from_log(log) - rotation).norm(), 1e-12) << degrees;
        EXPECT_LT((log - reference).norm(), 0.6) << degrees;
    }
}

TEST(LogNearTest, ATiltedTurnThroughAWholeTurnDoesNotJump)
{
    const Matrix3 tilt = rotation_from_log(Vector3(0.02, 0.01, 0.0));
    Vector3 last = Vector3::Zero();
    double largest = 0.0;
    for (int step = 0; step <= 800; ++step)
    {
        const Vector3 reference(0.0, 0.0, 0.5 * step * degree);
        const Vector3 log = log_near(tilt * rotation_from_log(reference), reference);
        if (step > 0)
            largest = std::max(largest, (log - last).norm());
        last = log;
    }
    EXPECT_LT(largest, 2.0 * degree);
}

TEST(LogNearTest, ThePolarRotationIsTheNearestOne)
{
    for (int k = 0; k < 200; ++k)
    {
        const Matrix3 matrix = Matrix3::Random();
        EXPECT_LT((polar_rotation(matrix) - nearest_rotation(matrix)).norm(), 1e-9);
    }
}

// Some of them flat or turned inside out, and no multiple of what is found at once.
TEST(LogNearTest, ManyPolarRotationsAtOnceAreThoseOfOneAfterTheOther)
{
    std::vector<Matrix3> matrices;
    for (int k = 0; k < 101; ++k)
        matrices.push_back(k % 10 == 3
                               ? Matrix3(Vector3::Random() * Vector3::Random().transpose())
                               : Matrix3(Matrix3::Random() + 2.0 * (k % 2) * Matrix3::Identity()));
    std::vector<Matrix3> found = matrices;
    make_rotations(found);
    for (std::size_t k = 0; k < matrices.size(); ++k)
    {
        EXPECT_LT((found[k] - polar_rotation(matrices[k])).norm(), 1e-9) << k;
        std::vector<Matrix3> alone = {matrices[k]};
        make_rotations(alone);
        EXPECT_EQ(alone.front(), found[k]) << k;
    }
}

TEST(LocalRotationsTest, WithoutLogsTheRotationsAreThoseWithAnyReference)
{
    const TriangleMesh mesh = shapes::grid(9, 7, 8.0, 6.0);
    Points bent = mesh.points();
    for (Eigen::Index k = 0; k < bent.rows(); ++k)
        bent.row(k) << 3.0 * std::sin(bent(k, 0) / 3.0), bent(k, 1) + 0.1 * bent(k, 0),
            3.0 - 3.0 * std::cos(bent(k, 0) / 3.0);
    const LocalRotationMeter meter(mesh, scene::all_vertices(mesh));
    const Points references = repeated(Vector3(0.1, -0.4, 0.2), mesh.vertex_count());
    const std::vector<Matrix3> logged = meter.measure(bent, references).matrices;
    const std::vector<Matrix3> found = meter.matrices(bent, Points(0, 3));
    for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_LT((found[k] - logged[k]).norm(), 1e-12) << k;
}

TEST(MeanMotionTest, ExistsForAStraightSourceAndTakesCentroidToCentroid)
{
    Points rest(3, 3), logs(3, 3);
    rest << 0, 0, 0, 1, 0, 0, 2, 0, 0;
    logs.setZero();
    logs.col(0).setConstant(0.4);
    const Points deformed = rest.rowwise() + Eigen::RowVector3d(1, 2, 3);
    const Matrix3 rotation = rotation_from_log(Vector3(0.4, 0, 0));
    const RigidMotion motion = mean_motion(rest, deformed, {{rotation, rotation, rotation}, logs});
    EXPECT_LT((motion.apply(Vector3(1, 0, 0)) - Vector3(2, 2, 3)).norm(), 1e-14);
    EXPECT_LT((motion.rotation_log - Vector3(0.4, 0, 0)).norm(), 1e-15);
    EXPECT_THROW(mean_motion(rest, deformed, {{rotation, rotation}, logs.topRows(2)}),
                 InvalidInput);
}

TEST(MeanMotionTest, HeavierVerticesCountMore)
{
    Points rest(3, 3), deformed(3, 3);
    rest << 0, 0, 0, 4, 0, 0, 0, 8, 0;
    deformed << 1, 0, 0, 4, 3, 0, 0, 8, 7;
    const std::vector<Matrix3> still(3, Matrix3::Identity());
    const RigidMotion motion =
        mean_motion(rest, deformed, {still, Points::Zero(3, 3)}, Vector3(1.0, 2.0, 5.0));
    EXPECT_LT((motion.pivot - Vector3(1.0, 5.0, 0.0)).norm(), 1e-14);
    EXPECT_LT((motion.translation - Vector3(0.125, 0.75, 4.375)).norm(), 1e-14);
}

TEST(MeanMotionTest, TurnsAsTheSourceDoesWhereNoLogNearbyTellsIt)
{
    const Points point = Points::Zero(1, 3);
    const Vector3 reference(3.1, 0.0, 0.0);  // nearly a whole turn
    const Matrix3 rotation = rotation_from_log(Vector3(0.1, 0.6, 0.2));
    const NearLogs told = logs_near({rotation}, reference.transpose());
    const RigidMotion motion = mean_motion(point, point, {{rotation}, told.logs, told.tilts});
    EXPECT_GT((rotation_from_log(told.logs.row(0).transpose()) - rotation).norm(), 0.1);
    EXPECT_LT((motion.rotation() - rotation).norm(), 1e-12);
}

}  // namespace

}  // namespace sheetmorph::volume

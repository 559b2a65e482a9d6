// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/surface_deformer.h"

#include "sheetmorph/base/errors.h"
#include "surface/strip.h"

#include <gmock/gmock.h>
#include <limits>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;
using cases::solve;
using cases::strip;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

double worst_difference(const Points& a, const Points& b)
{
    return (a - b).rowwise().norm().maxCoeff();
}

auto refuses(const Case& one)
{
    return [one] { solve(one); };
}

TEST(SurfaceDeformer, LiftsAClampedStripAsACubic)
{
    // 3 s^2 - 2 s^3, converging with the mesh.
    double last = 1.0;
    for (const int elements : {8, 16, 32, 64})
    {
        const Case one = strip(elements);
        const Points shape = solve(one).positions;
        double worst = 0.0;
        for (int i = 0; i < one.mesh.vertex_count(); ++i)
        {
            const double s = one.mesh.points()(i, 0) / 100.0;
            worst = std::max(worst, std::abs(shape(i, 2) / 10.0 - s * s * (3.0 - 2.0 * s)));
        }
        EXPECT_LT(worst, 0.75 * last);
        last = worst;
    }
    EXPECT_LT(last, 0.02);
}

TEST(SurfaceDeformer, PutsAPointOfATriangleExactlyOnItsTarget)
{
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
    {
        Case one = strip();
        one.constraints.energy = energy;
        one.constraints.points = {{"middle", 95, {0.2, 0.3, 0.5}, false}};
        one.targets.points = {{{48.0, 11.0, 17.0}, Vector3::Zero()}};
        const Points shape = solve(one).positions;
        Vector3 point = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            point += one.constraints.points[0].barycentric(k)
                     * shape.row(one.mesh.triangles()(95, k)).transpose();
        EXPECT_LT((point - one.targets.points[0].position).norm(), 1e-10);
    }
}

TEST(SurfaceDeformer, TurnsTheSheetAtATurnedPoint)
{
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
    {
        Case one = strip();
        one.constraints.energy = energy;
        one.constraints.points = {{"middle", 95, {0.2, 0.3, 0.5}, true}};
        const Vector3 log = rotation_log({0.0, 1.0, 0.0}, 0.4);
        one.targets.points = {{{48.0, 11.0, 5.0}, log}};
        const Deformation shape = solve(one);
        Vector3 turn = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            turn += one.constraints.points[0].barycentric(k)
                    * shape.rotation_logs.row(one.mesh.triangles()(95, k)).transpose();
        EXPECT_LT((turn - log).norm(), 1e-9);
    }
}

TEST(SurfaceDeformer, APartHeldByOnePointAloneFollowsItsTarget)
{
    Case one = strip();
    one.constraints.fixed.clear();
    one.constraints.handles.clear();
    one.targets.handles.clear();
    one.constraints.points = {{"centre", 95, {0.2, 0.3, 0.5}, false}};
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
    {
        one.constraints.energy = energy;
        Vector3 start = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            start += one.constraints.points[0].barycentric(k)
                     * one.mesh.points().row(one.mesh.triangles()(95, k)).transpose();
        const Vector3 shift(3.0, -2.0, 8.0);
        one.targets.points = {{start + shift, Vector3::Zero()}};
        const Points expected = one.mesh.points().rowwise() + shift.transpose();
        EXPECT_LT(worst_difference(solve(one).positions, expected), 1e-9);
    }
}

TEST(SurfaceDeformer, AcceptsRedundantPointsAndRefusesContradictingOnes)
{
    Case one = strip();
    one.constraints.points = {{"first", 95, {0.2, 0.3, 0.5}, false},
                              {"again", 95, {0.2, 0.3, 0.5}, false}};
    one.targets.points = {{{48.0, 11.0, 5.0}, Vector3::Zero()},
                          {{48.0, 11.0, 5.0}, Vector3::Zero()}};
    EXPECT_TRUE(solve(one).positions.allFinite());
    one.targets.points[1].position.z() = 6.0;
    EXPECT_THAT(refuses(one),
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("'again'"), HasSubstr("contradict"))));
}

TEST(SurfaceDeformer, APrescribedFeatureTurnsAsToldAndShiftsFreely)
{
    Case one = cases::flat_plate();
    one.constraints.features[1].rotation = FeatureRotation::prescribed;
    one.targets.feature_logs[1] = rotation_log({0.0, 0.0, 1.0}, 2.0 * shapes::pi / 3.0);
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
    {
        one.constraints.energy = energy;
        const RigidMotion motion = solve(one).features[1];
        EXPECT_LT((motion.rotation() - rotation_from_log(one.targets.feature_logs[1])).norm(),
                  1e-12);
        EXPECT_GT(motion.translation.norm(), 1.0);
    }
}

TEST(SurfaceDeformer, AFeatureThatAHandleTouchesMovesWithIt)
{
    Case one = cases::flat_plate();
    one.constraints.handles[0].vertices.push_back(one.constraints.features[2].vertices[5]);
    const Points shape = solve(one).positions;
    for (const int vertex : one.constraints.features[2].vertices)
        EXPECT_LT((shape.row(vertex).transpose()
                   - one.targets.handles[0].apply(Vector3(one.mesh.points().row(vertex))))
                      .norm(),
                  1e-12 * one.mesh.size());
}

TEST(SurfaceDeformer, FeaturesThatShareAVertexMoveAsOneBody)
{
    Case one = cases::flat_plate();
    one.constraints.features[1].vertices.push_back(one.constraints.features[0].vertices[3]);
    const Deformation shape = solve(one);
    EXPECT_EQ(shape.features[0].rotation_log, shape.features[1].rotation_log);
    const Vector3 centre = shape.features[1].pivot;
    EXPECT_LT((shape.features[0].apply(centre) - shape.features[1].apply(centre)).norm(), 1e-10);
}

TEST(SurfaceDeformer, APartWithoutFreeVerticesIsSimplyPlaced)
{
    Case one = strip(4);
    one.constraints.fixed.clear();
    one.constraints.handles[0] =
        cases::region("tip", one.mesh, [](const Vector3&) { return true; });
    EXPECT_EQ(solve(one).positions, one.targets.handles[0].apply(one.mesh.points()));
}

TEST(SurfaceDeformer, VerticesOfNoTriangleStayAtRest)
{
    Case one = strip();
    Points points(one.mesh.vertex_count() + 1, 3);
    points << one.mesh.points(), Eigen::RowVector3d(99.0, 12.0, 4.0);
    one.mesh = mesh::TriangleMesh(points, one.mesh.triangles());
    one.constraints.fixed.clear();
    one.targets.handles = {cases::motion({5.0, 6.0, 7.0}, {0.0, 1.0, 1.0}, 100.0, Vector3::Zero())};
    EXPECT_EQ(solve(one).positions.bottomRows(1), points.bottomRows(1));
    one.constraints.handles[0].vertices.push_back(one.mesh.vertex_count() - 1);
    EXPECT_EQ(solve(one).positions.bottomRows(1),
              one.targets.handles[0].apply(Points(points.bottomRows(1))));
}

// The strip with what real decks have: triangles twice, triangles of no area, a third triangle on
// an edge, collinear ones that close a T-junction.
Case ugly_strip()
{
    Case one = strip();
    const Triangles& t = one.mesh.triangles();
    const int n = one.mesh.vertex_count();
    Points points(n + 2, 3);
    const Eigen::RowVector3d a = one.mesh.points().row(t(41, 0));
    const Eigen::RowVector3d b = one.mesh.points().row(t(41, 1));
    points << one.mesh.points(), 0.5 * (a + b), 0.5 * (a + b) + Eigen::RowVector3d(0, 0, 6.0);
    Triangles triangles(t.rows() + 5, 3);
    triangles << t, t.row(30), Eigen::RowVector3i(t(50, 0), t(50, 0), t(50, 1)),
        Eigen::RowVector3i(t(41, 0), n, t(41, 1)), Eigen::RowVector3i(t(41, 0), n, n + 1),
        Eigen::RowVector3i(n, t(41, 1), n + 1);
    one.mesh = mesh::TriangleMesh(points, triangles);
    return one;
}

TEST(SurfaceDeformer, DuplicateDegenerateAndNonManifoldTrianglesWork)
{
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
    {
        Case one = ugly_strip();
        one.constraints.energy = energy;
        const Points clean = solve(strip()).positions;
        const Points shape = solve(one).positions;
        EXPECT_TRUE(shape.allFinite());
        EXPECT_LT(worst_difference(shape.topRows(clean.rows()), clean), 6.0);
        Case rigid = one;
        rigid.constraints.fixed.clear();
        rigid.targets.handles = {
            cases::motion({5.0, 6.0, 7.0}, {0.0, 1.0, 1.0}, 100.0, Vector3::Zero())};
        EXPECT_LT(worst_difference(solve(rigid).positions,
                                   rigid.targets.handles[0].apply(rigid.mesh.points())),
                  1e-9 * 100.0);
    }
}

TEST(SurfaceDeformer, AHandleTurnedByMoreThanHalfATurnTurnsTheSheetThatFar)
{
    Case one = strip(40);
    one.targets.handles = {
        cases::motion(Vector3::Zero(), {1.0, 0.0, 0.0}, 270.0, {100.0, 12.5, 0.0})};
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
    {
        one.constraints.energy = energy;
        const Points logs = solve(one).rotation_logs;
        const double half_turn = shapes::pi * 270.0 / 360.0;
        for (int i = 0; i < one.mesh.vertex_count(); ++i)
        {
            EXPECT_GT(logs(i, 0), -1e-6);
            EXPECT_LT(logs(i, 0), half_turn * (energy == Energy::paper ? 1.3 : 1.0 + 1e-12));
        }
    }
}

TEST(SurfaceDeformer, ReportsProgressAndStopsWhenAsked)
{
    const Case one = strip();
    double last = -1.0;
    const Progress watch(
        [&](double fraction, const std::string& task)
        {
            EXPECT_GE(fraction, last);
            EXPECT_FALSE(task.empty());
            last = fraction;
            return true;
        });
    const SurfaceDeformer deformer(one.mesh, one.constraints, watch);
    EXPECT_EQ(last, 1.0);
    const Progress stop([](double fraction, const std::string&) { return fraction < 0.15; });
    EXPECT_THROW(SurfaceDeformer(one.mesh, one.constraints, stop), Cancelled);
}

}  // namespace
}  // namespace sheetmorph::surface

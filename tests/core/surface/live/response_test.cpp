// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/response.h"

#include "sheetmorph/base/errors.h"
#include "surface/all_cases.h"
#include "surface/live/drawn_poses.h"

#include <gmock/gmock.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;
using cases::DrawnPoses;

//! What a response learns from.
struct Learning
{
    std::vector<int> handles = {0};
    double degrees = 90.0;
    int poses = 256;
};

std::unique_ptr<Response> learnt(const SurfaceDeformer& deformer, const Case& one,
                                 const Learning& from)
{
    return deformer.response(DrawnPoses(7).many(from.poses, one, from.handles, from.degrees),
                             {{}, true});
}

double share_of_size(const Case& one, const Points& a, const Points& b)
{
    return (a - b).rowwise().norm().maxCoeff() / one.mesh.size();
}

void expect_exact(const SurfaceDeformer& deformer, const Response& response, const Case& one)
{
    const auto frame = response.frame(one.targets);
    ASSERT_TRUE(frame.has_value()) << one.name;
    Deformation live;
    response.place(*frame, live);
    const Deformation exact = deformer.deform(one.targets);
    EXPECT_LT(share_of_size(one, live.positions, exact.positions), 1e-6) << one.name;
    EXPECT_LT((live.rotation_logs - exact.rotation_logs).cwiseAbs().maxCoeff(), 1e-6) << one.name;
    ASSERT_EQ(live.features.size(), exact.features.size());
    for (std::size_t k = 0; k < exact.features.size(); ++k)
    {
        EXPECT_LT((live.features[k].rotation() - exact.features[k].rotation()).norm(), 1e-6);
        EXPECT_LT((live.features[k].translation - exact.features[k].translation).norm(),
                  1e-6 * one.mesh.size());
    }
}

// Learns from poses and is asked for others.
void expect_exact_in_other_poses(Case one, const std::vector<int>& handles, double degrees,
                                 int poses = 256)
{
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = learnt(deformer, one, {handles, degrees, poses});
    ASSERT_TRUE(response->is_learnt()) << one.name;
    DrawnPoses drawn(99);
    for (int k = 0; k < 5; ++k)
    {
        one.targets = drawn.of(one, handles, 0.95 * degrees);
        expect_exact(deformer, *response, one);
    }
}

Case with_rotation(Case one, FeatureRotation rotation)
{
    for (FormFeature& feature : one.constraints.features)
        feature.rotation = rotation;
    return one;
}

// The same case with `count` handles: further ones in the middle of the sheet.
Case with_handles(Case one, int count)
{
    one.constraints.features.clear();
    one.targets.feature_logs.clear();
    for (int k = 1; k < count; ++k)
    {
        KnownRegion more{"more" + std::to_string(k), {}, "handle"};
        const Vector3 centre =
            one.mesh.points().row(k * one.mesh.vertex_count() / count).transpose();
        for (const int vertex : cases::patch("", one.mesh, centre, 9.0).vertices)
        {
            bool is_taken = false;
            for (const auto* regions : {&one.constraints.fixed, &one.constraints.handles})
                for (const KnownRegion& region : *regions)
                    is_taken =
                        is_taken
                        || std::count(region.vertices.begin(), region.vertices.end(), vertex);
            if (!is_taken)
                more.vertices.push_back(vertex);
        }
        one.constraints.handles.push_back(more);
        one.targets.handles.push_back({});
    }
    return one;
}

class ResponseCases : public testing::TestWithParam<Case>
{
};

// How far a handle turns; under `natural` not far (far_turns.h).
double degrees_of(const Case& one, double most)
{
    return one.constraints.energy == Energy::natural ? 60.0 : most;
}

TEST_P(ResponseCases, IsTheExactSolveOfOneTurningHandle)
{
    expect_exact_in_other_poses(GetParam(), {0}, degrees_of(GetParam(), 165.0), 128);
}

TEST_P(ResponseCases, IsTheMinimumOfFreeFeatures)
{
    expect_exact_in_other_poses(with_rotation(GetParam(), FeatureRotation::free), {0},
                                degrees_of(GetParam(), 100.0), 128);
}

INSTANTIATE_TEST_SUITE_P(All, ResponseCases, testing::ValuesIn(cases::all_with_every_energy()),
                         [](const auto& given) { return given.param.name; });

TEST(Response, TakesAnyNumberOfTurningHandles)
{
    for (int handles = 2; handles <= 4; ++handles)
    {
        std::vector<int> all;
        for (int k = 0; k < handles; ++k)
            all.push_back(k);
        expect_exact_in_other_poses(with_handles(cases::bent_plate(), handles), all,
                                    handles == 2 ? 100.0 : 75.0, handles == 2 ? 256 : 512);
    }
}

TEST(Response, TakesHandlesThatStandTurnedBesideOneThatIsDragged)
{
    Case one = with_handles(cases::bent_plate(), 3);
    one.targets = DrawnPoses(3).of(one, {1, 2}, 70.0);
    expect_exact_in_other_poses(one, {0}, 120.0);
}

TEST(Response, LeavesFarTurnsUnderNaturalToSubstitution)
{
    Case one = cases::bent_plate();
    one.constraints.energy = Energy::natural;
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = learnt(deformer, one, {{0}, 60.0});
    const auto turned = [&](double degrees)
    {
        SurfaceTargets targets = one.targets;
        targets.handles[0] =
            cases::motion({5.0, -3.0, 20.0}, {0.3, 1.0, 0.2}, degrees, {90.0, 40.0, 20.0});
        return targets;
    };
    EXPECT_TRUE(response->frame(turned(40.0)).has_value());
    for (const double degrees : {70.0, 150.0, 400.0})
    {
        EXPECT_FALSE(response->frame(turned(degrees)).has_value()) << degrees;
        const Points live = deformer.deform(turned(degrees), Exactness::live).positions;
        const Points exact = deformer.deform(turned(degrees)).positions;
        EXPECT_LT((live - exact).cwiseAbs().maxCoeff(), 1e-6 * one.mesh.size()) << degrees;
    }
}

TEST(Response, ReproducesLargeTurnsAboutAFarPivot)
{
    Case one = cases::bent_plate();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = learnt(deformer, one, {{0}, 165.0});
    one.targets.handles = {
        cases::motion({5.0, -3.0, 20.0}, {0.3, 1.0, 0.2}, 160.0, Vector3(900.0, -400.0, 200.0))};
    const auto frame = response->frame(one.targets);
    ASSERT_TRUE(frame.has_value());
    Deformation live;
    response->place(*frame, live);
    // The shift of the handle is several sizes: a millionth of that.
    const Points exact = deformer.deform(one.targets).positions;
    EXPECT_LT((live.positions - exact).rowwise().norm().maxCoeff(), 1e-6 * 2000.0);
}

TEST(Response, KeepsPointsOnTheirTargets)
{
    Case one = cases::bent_plate();
    const int triangle = one.mesh.triangle_count() / 2;
    one.constraints.points = {{"spot", triangle, {0.2, 0.3, 0.5}, false}};
    const Vector3 corner = one.mesh.points().row(one.mesh.triangles()(triangle, 0)).transpose();
    one.targets.points = {{corner + Vector3(1.0, 2.0, 6.0), Vector3::Zero()}};
    expect_exact_in_other_poses(one, {0}, 120.0);
    one.constraints.points[0].is_rotation_free = true;
    expect_exact_in_other_poses(with_rotation(one, FeatureRotation::free), {0}, 90.0);
}

TEST(Response, KeepsMotionsGroupsAndHandlesWhoseRotationIsFree)
{
    Case one = with_rotation(cases::bent_plate(), FeatureRotation::free);
    one.constraints.features[0].motion.type = FeatureMotion::Type::plane;
    one.constraints.features[0].motion.direction = Vector3::UnitZ();
    expect_exact_in_other_poses(one, {0}, 80.0);
    one = with_rotation(cases::bent_plate(), FeatureRotation::free);
    one.constraints.groups = {{0, 1}};
    expect_exact_in_other_poses(one, {0}, 80.0);
    one = with_rotation(cases::bent_plate(), FeatureRotation::free);
    one.constraints.handles[0].is_rotation_free = true;
    one.targets.handles[0].rotation_log.setZero();
    expect_exact_in_other_poses(one, {0}, 0.0);
}

TEST(Response, LaysSizesOn)
{
    Case one = with_rotation(cases::flat_plate(), FeatureRotation::free);
    one.constraints.features[0].is_resizable = true;
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = learnt(deformer, one, {{0}, 90.0});
    const double size =
        1.1
        * (one.mesh.points().row(one.constraints.features[0].vertices[0])
           - one.mesh.points().row(one.constraints.features[0]
                                       .vertices[one.constraints.features[0].vertices.size() / 2]))
              .norm();
    one.targets.sizes.assign(one.constraints.features.size(), std::nullopt);
    one.targets.sizes[0] = size;
    expect_exact(deformer, *response, one);
    one.targets.sizes[0] = -1.0;
    EXPECT_THROW(response->frame(one.targets), InvalidInput);
}

TEST(Response, TakesFollowersAndPrescribedFeaturesAlong)
{
    Case one = with_rotation(cases::bent_plate(), FeatureRotation::prescribed);
    one.targets.feature_logs.assign(one.constraints.features.size(), Vector3(0.0, 0.1, 0.05));
    Points points(one.mesh.vertex_count() + 1, 3);
    points.topRows(one.mesh.vertex_count()) = one.mesh.points();
    points.bottomRows(1) = one.mesh.points().row(40) + Eigen::RowVector3d(0.0, 0.0, 3.0);
    one.mesh = mesh::TriangleMesh(points, one.mesh.triangles());
    expect_exact_in_other_poses(one, {0}, 120.0);
}

TEST(Response, MeetsFixedAndHandleVerticesAsTheExactSolveDoes)
{
    const Case one = cases::flat_plate();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = learnt(deformer, one, {{0}, 165.0});
    Deformation live;
    response->place(response->frame(one.targets).value(), live);
    for (const int vertex : one.constraints.fixed[0].vertices)
        EXPECT_EQ(live.positions.row(vertex), one.mesh.points().row(vertex));
    for (const int vertex : one.constraints.handles[0].vertices)
        EXPECT_LT((Vector3(live.positions.row(vertex))
                   - one.targets.handles[0].apply(Vector3(one.mesh.points().row(vertex))))
                      .norm(),
                  1e-12);
}

TEST(Response, RefusesPosesThatAreNoBlendOfThoseLearntFrom)
{
    Case one = with_handles(cases::bent_plate(), 2);
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = learnt(deformer, one, {{0}, 90.0});
    EXPECT_TRUE(response->frame(one.targets).has_value());
    one.targets.handles[1].rotation_log = Vector3(0.0, 0.2, 0.0);
    EXPECT_FALSE(response->frame(one.targets).has_value());
    one.targets.handles[1] = {Vector3(0.0, 0.0, 1.0), Vector3::Zero(), Vector3::Zero()};
    EXPECT_FALSE(response->frame(one.targets).has_value());
    one.targets.handles[1] = {};
    one.targets.handles[0].rotation_log *= 9.0;
    EXPECT_FALSE(response->frame(one.targets).has_value());
}

TEST(Response, OfAPartThatNothingMovesIsItsRest)
{
    Case one = cases::flat_plate();
    one.targets.handles = {{}};
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = deformer.response({one.targets}, {});
    ASSERT_TRUE(response->is_learnt());
    Deformation live;
    response->place(response->frame(one.targets).value(), live);
    EXPECT_EQ(live.positions, one.mesh.points());
    one.targets.handles[0].translation = Vector3(0.0, 0.0, 1e-3);
    EXPECT_FALSE(response->frame(one.targets).has_value());
}

TEST(Response, StopsWhenItIsAskedTo)
{
    const Case one = cases::flat_plate();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const Progress stop([](double, const std::string&) { return false; });
    EXPECT_THROW(deformer.response({one.targets}, {}, stop), Cancelled);
}

}  // namespace
}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/surface_response.h"

#include "sheetmorph/base/errors.h"
#include "surface/all_cases.h"

#include <gmock/gmock.h>

namespace sheetmorph
{
namespace
{

using cases::Case;

// What the response says, or nothing.
std::optional<Deformation> answered(const Case& one, const ResponseOptions& options)
{
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto response = deformer.response(options);
    const auto frame = response->frame(one.targets);
    if (!frame)
        return std::nullopt;
    Deformation shape;
    response->place(*frame, true, shape);
    return shape;
}

double share_of_size(const Case& one, const Points& a, const Points& b)
{
    return (a - b).rowwise().norm().maxCoeff() / one.mesh.size();
}

void expect_exact_to_a_millionth(const Case& one, const ResponseOptions& options)
{
    const std::optional<Deformation> live = answered(one, options);
    ASSERT_TRUE(live.has_value()) << one.name;
    const Deformation exact = SurfaceDeformer(one.mesh, one.constraints).deform(one.targets);
    EXPECT_LT(share_of_size(one, live->positions, exact.positions), 1e-6) << one.name;
    EXPECT_LT((live->rotation_logs - exact.rotation_logs).cwiseAbs().maxCoeff(), 1e-12);
    ASSERT_EQ(live->features.size(), exact.features.size());
    for (std::size_t k = 0; k < exact.features.size(); ++k)
    {
        EXPECT_LT((live->features[k].rotation() - exact.features[k].rotation()).norm(), 1e-12);
        EXPECT_LT((live->features[k].translation - exact.features[k].translation).norm(),
                  1e-6 * one.mesh.size());
    }
}

// The same case with a second handle in the middle of the sheet.
Case with_second_handle(Case one)
{
    KnownRegion middle{"middle", {}, "handle"};
    const Vector3 centre = one.mesh.points().row(one.mesh.vertex_count() / 2).transpose();
    middle.vertices = cases::patch("", one.mesh, centre, 9.0).vertices;
    one.constraints.features.clear();
    one.targets.feature_logs.clear();
    one.constraints.handles.push_back(middle);
    one.targets.handles.push_back(cases::motion({2.0, 1.0, 9.0}, {1.0, 0.4, 0.0}, 50.0, centre));
    return one;
}

class SurfaceResponseCases : public testing::TestWithParam<Case>
{
};

TEST_P(SurfaceResponseCases, ReproducesTheExactSolveOfOneTurningHandle)
{
    expect_exact_to_a_millionth(GetParam(), {{0}, {}, 8});
}

INSTANTIATE_TEST_SUITE_P(All, SurfaceResponseCases,
                         testing::ValuesIn(cases::all_with_every_energy()),
                         [](const auto& given) { return given.param.name; });

TEST(SurfaceResponse, ReproducesLargeTurnsAboutAFarPivot)
{
    Case one = cases::bent_plate();
    one.targets.handles = {
        cases::motion({5.0, -3.0, 20.0}, {0.3, 1.0, 0.2}, 160.0, Vector3(900.0, -400.0, 200.0))};
    // The shift of the handle is several sizes: a millionth of that.
    const std::optional<Deformation> live = answered(one, {{0}, {}, 8});
    ASSERT_TRUE(live.has_value());
    const Points exact = SurfaceDeformer(one.mesh, one.constraints).deform(one.targets).positions;
    EXPECT_LT((live->positions - exact).rowwise().norm().maxCoeff(), 1e-6 * 2000.0);
    EXPECT_FALSE(live->positions.row(0).hasNaN());
}

TEST(SurfaceResponse, ReproducesTwoTurningHandles)
{
    expect_exact_to_a_millionth(with_second_handle(cases::flat_plate()), {{0, 1}, {}, 7});
    expect_exact_to_a_millionth(with_second_handle(cases::bent_plate()), {{0, 1}, {}, 7});
}

TEST(SurfaceResponse, ReproducesAHandleThatOnlyMovesBesideOneThatTurns)
{
    Case one = with_second_handle(cases::bent_plate());
    one.targets.handles[1].rotation_log.setZero();
    expect_exact_to_a_millionth(one, {{0}, {1}, 8});
}

TEST(SurfaceResponse, KeepsPointsOnTheirTargets)
{
    Case one = cases::bent_plate();
    one.constraints.points = {{"spot", one.mesh.triangle_count() / 2, {0.2, 0.3, 0.5}, false}};
    const auto corner = one.mesh.triangles()(one.mesh.triangle_count() / 2, 0);
    one.targets.points = {
        {Vector3(one.mesh.points().row(corner)) + Vector3(1.0, 2.0, 6.0), Vector3::Zero()}};
    expect_exact_to_a_millionth(one, {{0}, {}, 8});
}

TEST(SurfaceResponse, MeetsFixedAndHandleVerticesAsTheExactSolveDoes)
{
    const Case one = cases::flat_plate();
    const std::optional<Deformation> live = answered(one, {{0}, {}, 8});
    ASSERT_TRUE(live.has_value());
    for (const int vertex : one.constraints.fixed[0].vertices)
        EXPECT_EQ(live->positions.row(vertex), one.mesh.points().row(vertex));
    for (const int vertex : one.constraints.handles[0].vertices)
        EXPECT_LT((Vector3(live->positions.row(vertex))
                   - one.targets.handles[0].apply(Vector3(one.mesh.points().row(vertex))))
                      .norm(),
                  1e-12);
}

TEST(SurfaceResponse, DoesNotCoverWhatItHasNoFieldsFor)
{
    Case one = with_second_handle(cases::bent_plate());
    EXPECT_FALSE(answered(one, {{0}, {}, 8}).has_value());
    EXPECT_FALSE(answered(one, {{0}, {1}, 8}).has_value());
    one = cases::bent_plate();
    one.targets.handles[0].rotation_log *= 9.0;
    EXPECT_FALSE(answered(one, {{0}, {}, 8}).has_value());
    one = cases::bent_plate();
    one.constraints.features[0].rotation = FeatureRotation::prescribed;
    EXPECT_TRUE(answered(one, {{0}, {}, 8}).has_value());
    one.targets.feature_logs[0] = Vector3(0.0, 0.1, 0.0);
    EXPECT_FALSE(answered(one, {{0}, {}, 8}).has_value());
}

// Every feature free, as is the default.
Case set_free(Case one)
{
    for (FormFeature& feature : one.constraints.features)
        feature.rotation = FeatureRotation::free;
    return one;
}

TEST(SurfaceResponse, FindsTheMinimumOfFreeFeatures)
{
    for (const Case& one : {cases::flat_plate(), cases::bent_plate(), cases::graded_sheet()})
    {
        const Case free = set_free(one);
        const std::optional<Deformation> live = answered(free, {{0}, {}, 8});
        ASSERT_TRUE(live.has_value());
        const Deformation exact = SurfaceDeformer(free.mesh, free.constraints).deform(free.targets);
        EXPECT_LT(share_of_size(free, live->positions, exact.positions), 1e-6) << one.name;
        EXPECT_LT((live->rotation_logs - exact.rotation_logs).cwiseAbs().maxCoeff(), 1e-6);
        for (std::size_t k = 0; k < exact.features.size(); ++k)
            EXPECT_LT((live->features[k].rotation() - exact.features[k].rotation()).norm(), 1e-6);
    }
}

TEST(SurfaceResponse, FindsTheMinimumBetweenFarTurnedHandles)
{
    Case one = set_free(cases::bent_plate());
    one.targets.handles = {cases::motion({0.0, 5.0, 10.0}, {1.0, 0.1, 0.0}, 160.0, {90, 30, 0})};
    const std::optional<Deformation> live = answered(one, {{0}, {}, 8});
    ASSERT_TRUE(live.has_value());
    const Points exact = SurfaceDeformer(one.mesh, one.constraints).deform(one.targets).positions;
    EXPECT_LT(share_of_size(one, live->positions, exact), 1e-6);
}

TEST(SurfaceDeformer, KnowsWhetherItCanRespond)
{
    Case one = set_free(cases::flat_plate());
    EXPECT_TRUE(SurfaceDeformer(one.mesh, one.constraints).can_respond());
    one.constraints.features[0].motion.type = FeatureMotion::Type::plane;
    one.constraints.features[0].motion.direction = Vector3::UnitZ();
    EXPECT_FALSE(SurfaceDeformer(one.mesh, one.constraints).can_respond());
}

TEST(SurfaceResponse, StopsWhenItIsAskedTo)
{
    const Case one = cases::flat_plate();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const Progress stop([](double, const std::string&) { return false; });
    EXPECT_THROW(deformer.response({{0}, {}, 8}, stop), Cancelled);
}

}  // namespace
}  // namespace sheetmorph

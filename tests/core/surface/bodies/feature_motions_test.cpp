// SPDX-License-Identifier: LGPL-2.1-or-later
// What features may be told: motions, links, groups.
#include "sheetmorph/base/errors.h"
#include "surface/free_strip.h"

#include <gmock/gmock.h>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct MotionCase
{
    FeatureMotion::Type type;
    Vector3 point;
    Vector3 direction;
};

class FeatureMotions : public testing::TestWithParam<MotionCase>
{
};

// How far a motion is from what a FeatureMotion allows, mm or radians.
double violation(const FeatureMotion& motion, const RigidMotion& moved, const Vector3& centre)
{
    const Vector3 shift = moved.apply(centre) - centre;
    const Matrix3 rotation = moved.rotation();
    const double turned = (rotation - Matrix3::Identity()).norm();
    const Vector3& along = motion.direction;
    switch (motion.type)
    {
        case FeatureMotion::Type::fixed:
            return std::max(shift.norm(), turned);
        case FeatureMotion::Type::translation:
            return turned;
        case FeatureMotion::Type::plane:
            return std::max(std::abs(shift.dot(along)), (rotation * along - along).norm());
        case FeatureMotion::Type::line:
            return shift.cross(along).norm();
        case FeatureMotion::Type::axis:
            return std::max((moved.apply(motion.point) - motion.point).norm(),
                            (rotation * along - along).norm());
        case FeatureMotion::Type::free:
            break;
    }
    return 0.0;
}

TEST_P(FeatureMotions, AreKeptExactlyLiveAndExact)
{
    for (const bool is_curved : {false, true})
    {
        Case one = strip_with_holes(is_curved);
        one.targets.handles = {
            cases::motion({-10.0, 5.0, 40.0}, {0.2, 1.0, 0.1}, -35.0, {300.0, 50.0, 0.0})};
        FeatureMotion& motion = one.constraints.features[1].motion;
        motion = {GetParam().type, GetParam().point, GetParam().direction.normalized()};
        const SurfaceDeformer deformer(one.mesh, one.constraints);
        const Deformation exact = deformer.deform(one.targets);
        const Deformation live = deformer.deform(one.targets, Exactness::live);
        for (const Deformation& shape : {exact, live})
            EXPECT_LT(violation(motion, shape.features[1], centre_of(one, 1)), 1e-12 * 300.0);
        EXPECT_LT((exact.positions - live.positions).rowwise().norm().maxCoeff(), 3e-4);
        for (const int vertex : one.constraints.features[1].vertices)
            EXPECT_LT((exact.positions.row(vertex).transpose()
                       - exact.features[1].apply(Vector3(one.mesh.points().row(vertex))))
                          .norm(),
                      1e-10);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Every, FeatureMotions,
    testing::Values(MotionCase{FeatureMotion::Type::fixed, {0, 0, 0}, {0, 0, 1}},
                    MotionCase{FeatureMotion::Type::translation, {0, 0, 0}, {0, 0, 1}},
                    MotionCase{FeatureMotion::Type::plane, {0, 0, 0}, {0, 0, 1}},
                    MotionCase{FeatureMotion::Type::plane, {0, 0, 0}, {1, 2, 3}},
                    MotionCase{FeatureMotion::Type::line, {0, 0, 0}, {0, 0, 1}},
                    MotionCase{FeatureMotion::Type::line, {0, 0, 0}, {1, 1, 1}},
                    MotionCase{FeatureMotion::Type::axis, {150.0, 50.0, -40.0}, {0, 1, 0}},
                    MotionCase{FeatureMotion::Type::axis, {100.0, 20.0, 10.0}, {1, 1, 0}}));

// The minimum under a motion: no allowed motion nearby has a lower energy. Probed through the
// solver itself: the feature held (as a handle) where it is, or a little beside.
TEST(FeatureRelations, AHingedFeatureRestsWhereTheSheetPullsItLeast)
{
    Case one = strip_with_holes();
    one.constraints.features[1].motion = {
        FeatureMotion::Type::axis, {150.0, 50.0, 0.0}, {0.0, 1.0, 0.0}};
    const RigidMotion rest = solve(one).features[1];
    EXPECT_GT(rest.rotation_log.norm(), 0.02);
    const auto bent_with = [&](double change)
    {
        Case held = one;
        held.constraints.features.erase(held.constraints.features.begin() + 1);
        held.constraints.handles.push_back(
            {"held", one.constraints.features[1].vertices, "handle"});
        RigidMotion turn{Vector3::Zero(), rest.rotation_log, {150.0, 50.0, 0.0}};
        turn.rotation_log *= 1.0 + change;
        held.targets.handles.push_back(turn);
        held.targets.feature_logs.pop_back();
        return bending(held, solve(held).positions);
    };
    const double least = bent_with(0.0);
    EXPECT_GT(bent_with(0.25), least);
    EXPECT_GT(bent_with(-0.25), least);
}

TEST(FeatureRelations, AGroupMovesAsOneBody)
{
    Case one = strip_with_holes();
    one.constraints.groups = {{0, 2}};
    const Deformation shape = solve(one);
    const Vector3 a = centre_of(one, 0);
    const Vector3 b = centre_of(one, 2);
    EXPECT_LT((shape.features[0].apply(b) - shape.features[2].apply(b)).norm(), 1e-10);
    EXPECT_NEAR((shape.features[0].apply(a) - shape.features[2].apply(b)).norm(), (a - b).norm(),
                1e-10);
}

TEST(FeatureRelations, ADistanceIsKept)
{
    Case one = strip_with_holes();
    one.targets.handles = {
        cases::motion({-30.0, 10.0, 40.0}, {0.2, 1.0, 0.1}, -35.0, {300.0, 50.0, 0.0})};
    one.constraints.links = {{"bar", FeatureLinkType::distance, 2, 0, {}, {0, 0, 1}}};
    const Deformation shape = solve(one);
    const Vector3 a = shape.features[0].apply(centre_of(one, 0));
    const Vector3 b = shape.features[2].apply(centre_of(one, 2));
    EXPECT_NEAR((a - b).norm(), 200.0, 1e-10);
    EXPECT_GT((shape.features[0].rotation() - shape.features[2].rotation()).norm(), 1e-3);
    one.constraints.links.clear();
    const Deformation loose = solve(one);
    EXPECT_GT(std::abs((loose.features[0].apply(centre_of(one, 0))
                        - loose.features[2].apply(centre_of(one, 2)))
                           .norm()
                       - 200.0),
              0.1);
}

// How many times longer any edge became.
double longest_draw(const Case& one, const Points& after)
{
    double worst = 0.0;
    const Points& before = one.mesh.points();
    for (int t = 0; t < one.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = one.mesh.triangles()(t, k), b = one.mesh.triangles()(t, (k + 1) % 3);
            worst = std::max(worst, (after.row(a) - after.row(b)).norm()
                                        / (before.row(a) - before.row(b)).norm());
        }
    return worst;
}

TEST(FeatureRelations, SteelGoesAlongWithFeaturesOfADistance)
{
    Case one = strip_with_holes();
    one.targets.handles = {
        cases::motion({-30.0, 10.0, 40.0}, {0.2, 1.0, 0.1}, -35.0, {300.0, 50.0, 0.0})};
    one.constraints.links = {{"bar", FeatureLinkType::distance, 2, 0, {}, {0, 0, 1}}};
    const double linear = longest_draw(one, solve(one).positions);
    one.constraints.energy = Energy::steel;
    const Deformation shape = solve(one);
    const Vector3 a = shape.features[0].apply(centre_of(one, 0));
    const Vector3 b = shape.features[2].apply(centre_of(one, 2));
    EXPECT_NEAR((a - b).norm(), 200.0, 1e-9);
    EXPECT_LT(longest_draw(one, shape.positions), linear);
}

// Two holes one above the other: the ends of a bracket bent to a U.
Case bracket()
{
    Case one = strip_with_holes();
    const auto bend = [](const Vector3& p)
    {
        const double angle = shapes::pi * std::clamp((p.x() - 100.0) / 100.0, 0.0, 1.0);
        const double radius = 100.0 / shapes::pi;
        if (p.x() < 100.0)
            return Vector3(p.x(), p.y(), 0.0);
        if (p.x() > 200.0)
            return Vector3(300.0 - p.x(), p.y(), 2.0 * radius);
        return Vector3(100.0 + radius * std::sin(angle), p.y(), radius * (1.0 - std::cos(angle)));
    };
    one.mesh = shapes::mapped(one.mesh, bend);
    one.constraints.features.erase(one.constraints.features.begin() + 1);
    one.targets.feature_logs.pop_back();
    one.targets.handles = {
        cases::motion({6.0, 3.0, 15.0}, {0.3, 1.0, 0.2}, 12.0, {0.0, 50.0, 200.0 / shapes::pi})};
    return one;
}

TEST(FeatureRelations, CoaxialHolesStayCoaxial)
{
    Case one = bracket();
    one.constraints.links = {{"pin", FeatureLinkType::coaxial, 1, 0, centre_of(one, 0), {0, 0, 1}}};
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    for (const Exactness exactness : {Exactness::exact, Exactness::live})
    {
        const Deformation shape = deformer.deform(one.targets, exactness);
        const Vector3 axis = shape.features[0].rotation() * Vector3::UnitZ();
        EXPECT_LT((shape.features[1].rotation() * Vector3::UnitZ() - axis).norm(), 1e-12);
        const Vector3 between =
            shape.features[1].apply(centre_of(one, 1)) - shape.features[0].apply(centre_of(one, 0));
        EXPECT_LT(between.cross(axis).norm(), 1e-12 * 300.0);
    }
}

// Rims with their vertices on one side mostly: the mean of the vertices is off the axis.
TEST(FeatureRelations, TheAxisCountsNotTheMiddleOfTheVertices)
{
    Case one = bracket();
    const std::vector<Vector3> on_axis{centre_of(one, 0), centre_of(one, 1)};
    for (FormFeature& hole : one.constraints.features)
        hole.vertices.resize(2 * hole.vertices.size() / 3);
    ASSERT_GT((centre_of(one, 0) - on_axis[0]).norm(), 1.0);
    for (const int leader : {0, 1})
    {
        one.constraints.links = {
            {"pin", FeatureLinkType::coaxial, 1 - leader, leader, on_axis[leader], {0, 0, 1}}};
        const Deformation shape = solve(one);
        const Vector3 axis = shape.features[0].rotation() * Vector3::UnitZ();
        const Vector3 between =
            shape.features[1].apply(on_axis[1]) - shape.features[0].apply(on_axis[0]);
        EXPECT_LT((shape.features[1].rotation() * Vector3::UnitZ() - axis).norm(), 1e-12);
        EXPECT_LT(between.cross(axis).norm(), 1e-12 * 300.0);
    }
}

TEST(FeatureRelations, ALeaderInAnotherPartIsFollowedExactly)
{
    Case one = bracket();
    const Vector3 centre = centre_of(one, 1) - Vector3(0.0, 0.0, 30.0);
    one.constraints.links = {{"pin", FeatureLinkType::coaxial, 1, -1, centre, {0, 0, 1}}};
    one.targets.leaders = {cases::motion({4.0, -3.0, 8.0}, {1.0, 0.4, 0.3}, 20.0, centre)};
    const Deformation shape = solve(one);
    const Vector3 axis = one.targets.leaders[0].rotation() * Vector3::UnitZ();
    EXPECT_LT((shape.features[1].rotation() * Vector3::UnitZ() - axis).norm(), 1e-12);
    const Vector3 between =
        shape.features[1].apply(centre_of(one, 1)) - one.targets.leaders[0].apply(centre);
    EXPECT_LT(between.cross(axis).norm(), 1e-12 * 300.0);
}

TEST(FeatureRelations, ContradictionsAreNamed)
{
    Case one = strip_with_holes();
    const auto refused = [&] { solve(one); };
    one.constraints.features[1].motion.type = FeatureMotion::Type::line;
    one.constraints.fixed[0].vertices.push_back(one.constraints.features[1].vertices[0]);
    EXPECT_THAT(refused, ThrowsMessage<InvalidInput>(
                             AllOf(HasSubstr("hole1"), HasSubstr("line"), HasSubstr("fixed"))));
    one = strip_with_holes();
    one.constraints.features[0].motion.type = FeatureMotion::Type::plane;
    one.constraints.features[1].motion.type = FeatureMotion::Type::line;
    one.constraints.links = {{"pin", FeatureLinkType::coaxial, 1, 0, {}, {0, 0, 1}}};
    EXPECT_THAT(refused, ThrowsMessage<InvalidInput>(AllOf(HasSubstr("pin"), HasSubstr("hole1"))));
    one = strip_with_holes();
    one.constraints.features[0].motion.type = FeatureMotion::Type::plane;
    one.constraints.features[1].motion.type = FeatureMotion::Type::line;
    one.constraints.groups = {{0, 1}};
    EXPECT_THAT(refused,
                ThrowsMessage<InvalidInput>(AllOf(HasSubstr("hole0"), HasSubstr("plane"))));
}

}  // namespace
}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/relations.h"

#include "sheetmorph/assembly/session/deformation_session.h"
#include "sheetmorph/fitting/circle.h"
#include "assembly/frames.h"
#include "assembly/refusals.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

namespace sheetmorph::assembly
{

using namespace surface;

namespace
{

using frames::Frame;
using testing::HasSubstr;

// Two plates one above the other, holes over holes; the lower one is held and bent.
Frame stack()
{
    Frame frame{"stack", {}, {}};
    frames::add_plate(frame.assembly, "lower", {0.0, 0.0, 0.0}, true);
    frames::add_plate(frame.assembly, "upper", {0.0, 0.0, 5.0}, true);
    frame.assembly.fixed = {
        frames::side("root", frame.assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; }),
        frames::side("upper root", frame.assembly, 1,
                     [](const Vector3& p) { return p.x() < 1e-6; })};
    const PartRegion tip = frames::side("tip", frame.assembly, 0,
                                        [](const Vector3& p) { return p.x() > 180.0 - 1e-6; });
    frame.assembly.handles = {{tip.name, tip.part, tip.vertices, false}};
    frame.pose.handles["tip"] = frames::motion({0.0, 0.0, 25.0}, {0, 1, 0}, -20.0, {180, 30, 0});
    for (PartFeature& feature : frame.assembly.features)
        feature.rotation = FeatureRotation::free;
    return frame;
}

Vector3 centre(const Deformed& shape, int feature)
{
    const RigidMotion& motion = shape.features[static_cast<std::size_t>(feature)].motion;
    return motion.pivot + motion.translation;
}

// Of where the axis of feature b is from that of a: across it, and in direction (sine).
std::pair<double, double> misalignment(const Frame& frame, const Deformed& shape, int a, int b)
{
    const auto circle = [&](int index)
    {
        const PartFeature& feature = frame.assembly.features[static_cast<std::size_t>(index)];
        const Points& points = shape.parts[static_cast<std::size_t>(feature.part)].positions;
        return fitting::fit_circle(points(feature.vertices, Eigen::indexing::all));
    };
    const fitting::CircleFit one = circle(a);
    const fitting::CircleFit other = circle(b);
    const Vector3 way = other.centre - one.centre;
    return {(way - way.dot(one.axis) * one.axis).norm(), one.axis.cross(other.axis).norm()};
}

}  // namespace

TEST(Relations, CoaxialHolesOfTwoPartsStayCoaxial)
{
    Frame frame = stack();
    frame.assembly.pairs = {{"bolt", FeatureLinkType::coaxial, 2, 5}};
    const DeformationSession session(frame.assembly);
    EXPECT_EQ(session.plan().level[1], 1);  // the pair makes them neighbours
    const Deformed shape = session.deform(frame.pose);
    EXPECT_GT((centre(shape, 2) - shape.features[2].motion.pivot).norm(), 5.0);
    const auto [across_at_rest, turned_at_rest] = misalignment(frame, session.deform({}), 2, 5);
    const auto [across, turned] = misalignment(frame, shape, 2, 5);
    EXPECT_NEAR(across, across_at_rest, 1e-10);  // the plates are bent: not quite zero
    EXPECT_NEAR(turned, turned_at_rest, 1e-11);
    for (const FeatureResult& feature : shape.features)
        EXPECT_LT(feature.edge_error, 1e-11);
}

TEST(Relations, HolesThatKeepTheirDistanceKeepIt)
{
    Frame frame = stack();
    frame.assembly.pairs = {{"pitch", FeatureLinkType::distance, 1, 2},
                            {"across", FeatureLinkType::distance, 2, 4}};
    const Deformed rest = DeformationSession(frame.assembly).deform({});
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    for (const auto& [a, b] : {std::pair(1, 2), std::pair(2, 4)})
        EXPECT_NEAR((centre(shape, a) - centre(shape, b)).norm(),
                    (centre(rest, a) - centre(rest, b)).norm(), 1e-10);
}

TEST(Relations, AGroupMovesAsOneBody)
{
    Frame frame = stack();
    frame.assembly.groups = {{"flange", {0, 1, 2}}};
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    const RigidMotion& first = shape.features[0].motion;
    for (const int other : {1, 2})
    {
        const RigidMotion& motion = shape.features[static_cast<std::size_t>(other)].motion;
        EXPECT_LT((motion.rotation() - first.rotation()).norm(), 1e-12);
        EXPECT_LT((first.apply(motion.pivot) - motion.apply(motion.pivot)).norm(), 1e-10);
    }
}

TEST(Relations, HolesThatShareNoAxisAreRefusedWithTheOffset)
{
    Frame frame = stack();
    frame.assembly.pairs = {{"bolt", FeatureLinkType::coaxial, 0, 4}};
    EXPECT_THAT(refusal(frame), HasSubstr("feature 'lower hole0' of part 'lower' and feature "
                                          "'upper hole1' of part 'upper' do not share an axis at "
                                          "rest, they are 60 mm and "));
    frame.assembly.pairs = {{"bolt", FeatureLinkType::coaxial, 0, 0}};
    EXPECT_THAT(refusal(frame), HasSubstr("twice"));
}

TEST(Relations, AGroupAcrossPartsPointsToARigidContact)
{
    Frame frame = stack();
    frame.assembly.groups = {{"flange", {0, 3}}};
    EXPECT_THAT(refusal(frame), HasSubstr("'lower hole0' of part 'lower' and feature 'upper hole0' "
                                          "of part 'upper'; a group is on one part, join parts by "
                                          "a contact of type rigid"));
    frame.assembly.groups = {{"flange", {0}}};
    EXPECT_THAT(refusal(frame), HasSubstr("fewer than two"));
}

TEST(Relations, FeaturesOfOnePlaceHaveNoDistance)
{
    Frame frame = stack();
    frame.assembly.features.push_back(frame.assembly.features[0]);
    frame.assembly.features.back().name = "again";
    frame.assembly.pairs = {{"pitch", FeatureLinkType::distance, 0, 6}};
    EXPECT_THAT(refusal(frame), HasSubstr("have the same centre"));
}

}  // namespace sheetmorph::assembly

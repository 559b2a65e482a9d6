// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/link_plan.h"

#include "assembly/frames.h"
#include "assembly/refusals.h"

#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

using frames::Frame;

// How far, at most, places of several parts change their distances, mm.
double miss_of_one_body(const Assembly& assembly, const Deformed& shape,
                        const std::vector<PartRegion>& sides)
{
    std::vector<Vector3> rest, moved;
    for (const PartRegion& side : sides)
        for (const int vertex : side.vertices)
        {
            const auto part = static_cast<std::size_t>(side.part);
            rest.emplace_back(assembly.parts[part].mesh.points().row(vertex));
            moved.emplace_back(shape.parts[part].positions.row(vertex));
        }
    double worst = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            worst = std::max(worst,
                             std::abs((rest[i] - rest[j]).norm() - (moved[i] - moved[j]).norm()));
    return worst;
}

std::vector<PartRegion> sides_of(const Assembly& assembly, const std::vector<int>& contacts)
{
    std::vector<PartRegion> sides;
    for (const int k : contacts)
        for (const PartRegion& side : {assembly.contacts[static_cast<std::size_t>(k)].a,
                                       assembly.contacts[static_cast<std::size_t>(k)].b})
            sides.push_back(side);
    return sides;
}

TEST(WeldPlan, AStackOfRigidContactsOnOneVertexSetIsOneBody)
{
    Frame frame = frames::ring(ContactType::rigid);
    frame.assembly.contacts[3].b = frame.assembly.contacts[1].b;
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    EXPECT_LT(miss_of_one_body(frame.assembly, shape, sides_of(frame.assembly, {1, 3})), 1e-9);
}

TEST(WeldPlan, AFeatureBetweenTwoRigidContactsMakesThemOneBody)
{
    Frame frame = frames::ring(ContactType::rigid);
    frame.assembly.features.push_back({"brace",
                                       2,
                                       {frame.assembly.contacts[1].b.vertices.front(),
                                        frame.assembly.contacts[3].b.vertices.front()},
                                       surface::FeatureRotation::free,
                                       {},
                                       {},
                                       false});
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    EXPECT_LT(miss_of_one_body(frame.assembly, shape, sides_of(frame.assembly, {1, 3})), 1e-9);
}

// Every layer touches every other one, as a bolt through three sheets is found.
TEST(WeldPlan, ThreeLayersOnOneBoltSolveWhicheverIsDeformedFirst)
{
    for (const int primary : {0, 1, 2})
    {
        Assembly assembly;
        frames::add_plate(assembly, "upper", {0.0, 0.0, 0.0}, true);
        frames::add_plate(assembly, "middle", {150.0, 0.0, 1.5}, true);
        frames::add_plate(assembly, "lower", {150.0, 0.0, -1.5}, true);
        frames::add_contact(assembly, 0, 1, 150.0);
        frames::add_contact(assembly, 0, 2, 150.0);
        frames::add_contact(assembly, 1, 2, 150.0);
        for (Contact& contact : assembly.contacts)
            contact.type = ContactType::rigid;
        const auto over = [](const Vector3& p) { return p.x() > 149.0 && p.x() < 181.0; };
        assembly.contacts[2] = {"middle - lower", ContactType::rigid,
                                frames::side("a", assembly, 1, over),
                                frames::side("b", assembly, 2, over)};
        assembly.primary = primary;
        const auto moved = static_cast<std::size_t>(primary);
        const Points& points = assembly.parts[moved].mesh.points();
        const bool is_first = primary == 0;
        const double end = is_first ? points.col(0).minCoeff() : points.col(0).maxCoeff();
        const PartRegion tip =
            frames::side("tip", assembly, primary,
                         [&](const Vector3& p) { return std::abs(p.x() - end) < 1e-6; });
        assembly.handles = {{tip.name, tip.part, tip.vertices}};
        Pose pose;
        pose.handles["tip"] = frames::motion({0, 0, 20}, {0, 1, 0}, 10.0, {0, 0, 0});
        const Deformed shape = DeformationSession(assembly).deform(pose);
        EXPECT_LT(miss_of_one_body(assembly, shape, sides_of(assembly, {0, 1, 2})), 1e-9);
    }
}

TEST(WeldPlan, WhatIsFixedOnADrivenPartHoldsTheWholeStack)
{
    Frame frame = frames::ring(ContactType::rigid);
    const PartRegion& driven = frame.assembly.contacts[0].b;
    frame.assembly.fixed = {{"clamp", driven.part, {driven.vertices[2]}}};
    frame.assembly.handles.front().vertices =
        frames::side("tip", frame.assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; })
            .vertices;
    const DeformationSession session(frame.assembly);
    const Deformed shape = session.deform(frame.pose);
    for (const PartRegion& side : sides_of(frame.assembly, {0}))
        for (const int vertex : side.vertices)
        {
            const auto part = static_cast<std::size_t>(side.part);
            EXPECT_EQ(shape.parts[part].positions.row(vertex),
                      frame.assembly.parts[part].mesh.points().row(vertex));
        }
    EXPECT_TRUE(session.is_held(0));
    EXPECT_FALSE(session.is_held(2));
}

}  // namespace
}  // namespace sheetmorph::assembly

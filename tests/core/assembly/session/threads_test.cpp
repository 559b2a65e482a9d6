// SPDX-License-Identifier: LGPL-2.1-or-later
// The shape does not depend on how many threads work on it, not in a bit.
#include "sheetmorph/assembly/session/live_drag.h"
#include "sheetmorph/base/threads/parallel.h"
#include "assembly/frames.h"

#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

using frames::Frame;

// Exact shapes, a frame by substitution and one by responses.
std::vector<Points> all_shapes(const Frame& frame, int threads)
{
    const ThreadCount some(threads);
    const DeformationSession session(frame.assembly);
    const auto drag = session.begin_drag({"tip"}, frame.pose, {1});
    drag->wait();
    std::vector<Points> found;
    const auto add = [&](const Deformed& shape)
    {
        for (const surface::Deformation& part : shape.parts)
            found.push_back(part.positions);
    };
    add(session.deform(frame.pose));
    add(session.deform(frame.pose, Exactness::live));
    add(*drag->frame(frame.pose));
    return found;
}

void expect_same_bits(const Frame& frame)
{
    const std::vector<Points> expected = all_shapes(frame, 1);
    for (const int threads : {2, 3, 8})
    {
        const std::vector<Points> found = all_shapes(frame, threads);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            EXPECT_TRUE((found[k].array() == expected[k].array()).all())
                << frame.name << ", shape " << k << " on " << threads << " threads";
    }
}

TEST(Threads, TheirNumberChangesNoBitOfAnAssembly)
{
    for (const ContactType type : {ContactType::control_mesh, ContactType::tied})
        expect_same_bits(frames::ring(type));
}

TEST(Threads, TheirNumberChangesNoBitOfALargePart)
{
    Frame frame{"large", {}, {}};
    Part part;
    part.name = "sheet";
    part.mesh = shapes::grid(210, 150, 420.0, 300.0);
    frame.assembly.parts = {part};
    frame.assembly.fixed = {
        frames::side("root", frame.assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; })};
    const PartRegion tip = frames::side("tip", frame.assembly, 0,
                                        [](const Vector3& p) { return p.x() > 420.0 - 1e-6; });
    frame.assembly.handles = {{tip.name, 0, tip.vertices}};
    frame.pose.handles["tip"] =
        frames::motion({-3.0, 2.0, 40.0}, {0.1, 1.0, 0.2}, 25.0, {420.0, 150.0, 0.0});
    expect_same_bits(frame);
}

}  // namespace
}  // namespace sheetmorph::assembly

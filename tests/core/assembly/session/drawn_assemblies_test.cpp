// SPDX-License-Identifier: LGPL-2.1-or-later
// Whatever the assembly, every way to an answer is the exact one.
#include "sheetmorph/assembly/session/live_drag.h"

#include "sheetmorph/base/errors.h"
#include "assembly/drawn_assembly.h"
#include "assembly/refusals.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <limits>

namespace sheetmorph::assembly
{
namespace
{

using frames::DrawnAssembly;
using frames::Frame;

// However small the assembly is.
const DragOptions learning{0, {}};

double size_of(const Assembly& assembly)
{
    Eigen::AlignedBox3d box;
    for (const Part& part : assembly.parts)
        for (const auto& point : part.mesh.points().rowwise())
            box.extend(Vector3(point.transpose()));
    return box.diagonal().norm();
}

// How far an answer is from another, of the size of the assembly; a form feature that turns by a
// radian moves its rim by less than a tenth of that.
double miss(const Frame& frame, const Deformed& a, const Deformed& b)
{
    double shift = 0.0, turn = 0.0;
    for (std::size_t part = 0; part < b.parts.size(); ++part)
    {
        if (!a.parts[part].positions.allFinite())
            return std::numeric_limits<double>::infinity();
        shift = std::max(
            shift, (a.parts[part].positions - b.parts[part].positions).rowwise().norm().maxCoeff());
    }
    for (std::size_t k = 0; k < b.features.size(); ++k)
    {
        const RigidMotion &one = a.features[k].motion, &other = b.features[k].motion;
        shift = std::max(shift, (one.translation - other.translation).norm());
        turn = std::max(turn, (one.rotation() - other.rotation()).norm());
    }
    return std::max(shift / size_of(frame.assembly), 0.1 * turn);
}

// What some draws ask for contradicts itself: the first one from a seed on that does not.
DrawnAssembly drawn_from(unsigned seed)
{
    for (unsigned next = 1000 * seed;; ++next)
        if (DrawnAssembly drawn(next); refusal(drawn.frame()).empty())
            return drawn;
}

// The assembly before its last feature, handle or part came.
Assembly earlier(Assembly assembly)
{
    assembly.groups.clear();
    assembly.pairs.clear();
    if (assembly.features.size() % 2 == 0 && assembly.handles.size() > 1)
        assembly.handles.pop_back();
    else if (!assembly.features.empty())
        assembly.features.pop_back();
    return assembly;
}

// A session that takes over what it can of one before.
DeformationSession changed(const Frame& frame)
{
    try
    {
        const DeformationSession before(earlier(frame.assembly));
        return DeformationSession(frame.assembly, {}, &before);
    }
    catch (const InvalidInput&)
    {
        return DeformationSession(frame.assembly);
    }
}

// Whether a part may turn by 60 degrees between two things that move it: there `natural` bends a
// laid shape, which no response holds.
bool may_turn_far(const Frame& frame)
{
    constexpr double half_of_half = shapes::pi / 12.0;  // logs are of half the angle
    double farthest = 0.0;
    for (const auto& [name, motion] : frame.pose.handles)
        farthest = std::max(farthest, motion.rotation_log.norm());
    for (const auto& [name, log] : frame.pose.feature_logs)
        farthest = std::max(farthest, log.norm());
    for (const auto& [name, target] : frame.pose.points)
        farthest = std::max(farthest, target.rotation_log.norm());
    return frame.assembly.energy == surface::Energy::natural && farthest > half_of_half;
}

class DrawnAssemblies : public testing::TestWithParam<unsigned>
{
};

TEST_P(DrawnAssemblies, AreAnsweredAlikeInEveryWay)
{
    DrawnAssembly drawn = drawn_from(GetParam());
    const Frame frame = drawn.frame();
    SCOPED_TRACE(frame.name);
    const DeformationSession session(frame.assembly);
    const Deformed exact = session.deform(frame.pose);
    EXPECT_LT(miss(frame, changed(frame).deform(frame.pose), exact), 1e-9) << "changed";
    EXPECT_LT(miss(frame, session.deform(frame.pose, Exactness::live), exact), 1e-6);
    const auto drag = session.begin_drag(drawn.dragged(), frame.pose, learning);
    EXPECT_LT(miss(frame, *drag->frame(frame.pose), exact), 1e-6) << "while it learns";
    drag->wait();
    EXPECT_LT(miss(frame, *drag->frame(frame.pose), exact), 1e-6) << "learnt";
    EXPECT_TRUE(drag->answered()[0] || session.thin_solid(0) != nullptr || may_turn_far(frame));
    for (int k = 0; k < 3; ++k)
    {
        const Pose pose = drawn.another_pose();
        if (!refusal({"", frame.assembly, pose}).empty())
            continue;
        EXPECT_LT(miss(frame, *drag->frame(pose), session.deform(pose)), 1e-6) << "pose " << k;
    }
    EXPECT_LT(miss(frame, *drag->frame(frame.pose), exact), 1e-6) << "again";
}

INSTANTIATE_TEST_SUITE_P(Seeds, DrawnAssemblies, testing::Range(16U, 56U));

}  // namespace
}  // namespace sheetmorph::assembly

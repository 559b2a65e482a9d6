// SPDX-License-Identifier: LGPL-2.1-or-later
// The invariants of whole assemblies, for every propagation, mode and contact type.
#include "assembly/all_frames.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

using frames::Frame;

double size_of(const Assembly& assembly)
{
    Eigen::RowVector3d low = assembly.parts[0].mesh.points().colwise().minCoeff();
    Eigen::RowVector3d high = assembly.parts[0].mesh.points().colwise().maxCoeff();
    for (const Part& part : assembly.parts)
    {
        low = low.cwiseMin(part.mesh.points().colwise().minCoeff());
        high = high.cwiseMax(part.mesh.points().colwise().maxCoeff());
    }
    return (high - low).norm();
}

double worst_difference(const Points& a, const Points& b)
{
    return (a - b).rowwise().norm().maxCoeff();
}

std::vector<Points> solve(const Frame& frame)
{
    std::vector<Points> positions;
    for (surface::Deformation& part : DeformationSession(frame.assembly).deform(frame.pose).parts)
        positions.push_back(std::move(part.positions));
    return positions;
}

// The frame with every mesh passed through a linear map and a shift.
Frame mapped(const Frame& frame, const Matrix3& map, const Vector3& shift)
{
    Frame seen = frame;
    for (Part& part : seen.assembly.parts)
        part.mesh =
            mesh::TriangleMesh((part.mesh.points() * map.transpose()).rowwise() + shift.transpose(),
                               part.mesh.triangles());
    RigidMotion& tip = seen.pose.handles["tip"];
    tip.pivot = map * tip.pivot + shift;
    tip.translation = map * tip.translation;
    return seen;
}

class AssemblyInvariants : public testing::TestWithParam<Frame>
{
protected:
    // Compares the mapped frame's answer with the mapped answer of the frame.
    void expect_mapped_answer(const Frame& seen, const Matrix3& map, const Vector3& shift)
    {
        const std::vector<Points> expected = solve(GetParam());
        const std::vector<Points> found = solve(seen);
        const double size = size_of(seen.assembly);
        for (std::size_t k = 0; k < expected.size(); ++k)
            EXPECT_LT(worst_difference(
                          found[k], (expected[k] * map.transpose()).rowwise() + shift.transpose()),
                      1e-9 * size)
                << GetParam().assembly.parts[k].name;
    }
};

TEST_P(AssemblyInvariants, WithoutMotionEveryPartIsAtRest)
{
    Frame frame = GetParam();
    frame.pose = {};
    const std::vector<Points> positions = solve(frame);
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
        const Points& rest = frame.assembly.parts[k].mesh.points();
        EXPECT_LE(worst_difference(positions[k], rest),
                  mesh::exactness(rest, size_of(frame.assembly)));
    }
}

TEST_P(AssemblyInvariants, EveryPartButTheFirstMovesWithTheHandle)
{
    const Frame& frame = GetParam();
    const std::vector<Points> positions = solve(frame);
    for (std::size_t k = 0; k < positions.size(); ++k)
        EXPECT_GT(worst_difference(positions[k], frame.assembly.parts[k].mesh.points()), 5.0);
}

TEST_P(AssemblyInvariants, OneRigidMotionOfEverythingMovesEveryPartRigidly)
{
    Frame frame = GetParam();
    const RigidMotion motion = frames::motion({30, -20, 50}, {0.3, -0.7, 0.4}, 170.0, {5, 8, -3});
    const PartRegion root = frame.assembly.fixed.front();
    frame.assembly.fixed.clear();
    frame.assembly.handles.push_back({root.name, root.part, root.vertices});
    frame.pose.handles = {{"tip", motion}, {"root", motion}};
    const std::vector<Points> positions = solve(frame);
    for (std::size_t k = 0; k < positions.size(); ++k)
        EXPECT_LT(
            worst_difference(positions[k], motion.apply(frame.assembly.parts[k].mesh.points())),
            1e-9 * size_of(frame.assembly))
            << frame.assembly.parts[k].name;
}

TEST_P(AssemblyInvariants, FeaturesOfEveryPartStayRigid)
{
    const Frame& frame = GetParam();
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    const double size = size_of(frame.assembly);
    for (const FeatureResult& feature : shape.features)
    {
        const Points& rest =
            frame.assembly.parts[static_cast<std::size_t>(feature.part)].mesh.points();
        EXPECT_LT(feature.edge_error, mesh::exactness(rest, size)) << feature.name;
    }
}

TEST_P(AssemblyInvariants, ATurnedModelGivesTheTurnedAnswer)
{
    const RigidMotion view = frames::motion({300, 20, -50}, {0.5, 0.2, -0.9}, 77.0, {0, 0, 0});
    Frame seen = mapped(GetParam(), view.rotation(), view.translation);
    RigidMotion& tip = seen.pose.handles["tip"];
    tip.rotation_log = view.rotation() * tip.rotation_log;
    expect_mapped_answer(seen, view.rotation(), view.translation);
}

TEST_P(AssemblyInvariants, MillimetresAndMetresGiveTheSameShape)
{
    const Matrix3 metres = 1e-3 * Matrix3::Identity();
    expect_mapped_answer(mapped(GetParam(), metres, Vector3::Zero()), metres, Vector3::Zero());
}

TEST_P(AssemblyInvariants, AMirroredModelGivesTheMirroredAnswer)
{
    const Matrix3 flip = Vector3(1.0, -1.0, 1.0).asDiagonal();
    Frame seen = mapped(GetParam(), flip, Vector3::Zero());
    RigidMotion& tip = seen.pose.handles["tip"];
    tip.rotation_log = -(flip * tip.rotation_log);
    expect_mapped_answer(seen, flip, Vector3::Zero());
}

TEST_P(AssemblyInvariants, TheOrderOfThePartsDoesNotMatter)
{
    const Frame& frame = GetParam();
    Frame other = frame;
    const int last = static_cast<int>(frame.assembly.parts.size()) - 1;
    std::reverse(other.assembly.parts.begin(), other.assembly.parts.end());
    other.assembly.primary = last - frame.assembly.primary;
    const auto renumber = [&](auto& list)
    {
        for (auto& item : list)
            item.part = last - item.part;
    };
    renumber(other.assembly.fixed);
    renumber(other.assembly.handles);
    renumber(other.assembly.features);
    renumber(other.assembly.followers);
    for (Contact& contact : other.assembly.contacts)
    {
        contact.a.part = last - contact.a.part;
        contact.b.part = last - contact.b.part;
    }
    const std::vector<Points> expected = solve(frame);
    const std::vector<Points> found = solve(other);
    for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_LT(worst_difference(found[expected.size() - 1 - k], expected[k]),
                  1e-9 * size_of(frame.assembly));
}

TEST_P(AssemblyInvariants, TheSameInputGivesTheSameBits)
{
    EXPECT_EQ(solve(GetParam()), solve(GetParam()));
}

// The longest way any vertex of any part goes while the handle turns by one step.
double longest_step(const Frame& frame, double from, double to, double step)
{
    Frame turned = frame;
    const DeformationSession session(frame.assembly);
    std::vector<Points> last;
    double longest = 0.0;
    for (double degrees = from; degrees <= to + 1e-9; degrees += step)
    {
        turned.pose.handles["tip"] =
            frames::motion(Vector3::Zero(), {1.0, 0.0, 0.0}, degrees, {180.0, 30.0, 0.0});
        std::vector<Points> now;
        for (surface::Deformation& part : session.deform(turned.pose, Exactness::live).parts)
            now.push_back(std::move(part.positions));
        for (std::size_t k = 0; k < last.size(); ++k)
            longest = std::max(longest, worst_difference(now[k], last[k]));
        last = std::move(now);
    }
    return longest;
}

TEST_P(AssemblyInvariants, AHandleTurnedThroughMoreThanAWholeTurnMovesEveryPartContinuously)
{
    // A leap would not become shorter with the steps; a continuous motion goes a quarter of the
    // way.
    const double coarse = longest_step(GetParam(), 0.0, 400.0, 4.0);
    const double fine = longest_step(GetParam(), 0.0, 400.0, 1.0);
    EXPECT_LT(fine, 0.4 * coarse);
    EXPECT_LT(coarse, 0.3 * size_of(GetParam().assembly));
}

INSTANTIATE_TEST_SUITE_P(Frames, AssemblyInvariants, testing::ValuesIn(frames::all()),
                         [](const testing::TestParamInfo<Frame>& each) { return each.param.name; });

}  // namespace
}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/live_drag.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "assembly/all_frames.h"

#include <gtest/gtest.h>
#include <set>

namespace sheetmorph::assembly
{
namespace
{

using frames::Frame;

// However small the assembly is.
const DragOptions learning{0, {}};

double worst_share(const Frame& frame, const Deformed& a, const Deformed& b)
{
    double size = 0.0, worst = 0.0;
    for (std::size_t part = 0; part < a.parts.size(); ++part)
    {
        size = std::max(size, frame.assembly.parts[part].mesh.size());
        worst = std::max(
            worst, (a.parts[part].positions - b.parts[part].positions).rowwise().norm().maxCoeff());
    }
    return worst / size;
}

class LiveDragContacts : public testing::TestWithParam<ContactType>
{
};

TEST_P(LiveDragContacts, FramesAreThoseOfTheExactSolveBeforeAndAfterTheResponsesAreThere)
{
    const Frame frame = frames::ring(GetParam());
    const DeformationSession session(frame.assembly);
    const Deformed exact = session.deform(frame.pose);
    const auto drag = session.begin_drag({"tip"}, {}, learning);
    EXPECT_LT(worst_share(frame, *drag->frame(frame.pose), exact), 1e-6);
    drag->wait();
    ASSERT_TRUE(drag->is_ready());
    EXPECT_LT(worst_share(frame, *drag->frame(frame.pose), exact), 1e-6);
    EXPECT_TRUE(drag->answered()[0]);
    for (std::size_t k = 0; k < exact.features.size(); ++k)
        EXPECT_LT((drag->frame(frame.pose)->features[k].motion.translation
                   - exact.features[k].motion.translation)
                      .norm(),
                  1e-3);
}

TEST_P(LiveDragContacts, FramesDoNotDependOnThoseBefore)
{
    const Frame frame = frames::ring(GetParam());
    const DeformationSession session(frame.assembly);
    const auto drag = session.begin_drag({"tip"}, {}, learning);
    drag->wait();
    const Deformed first = *drag->frame(frame.pose);
    Pose other = frame.pose;
    other.handles["tip"].translation *= 2.0;
    drag->frame(other);
    EXPECT_EQ(worst_share(frame, *drag->frame(frame.pose), first), 0.0);
}

// Parts that do not move each other are answered at the same time.
TEST_P(LiveDragContacts, FramesAreTheSameBitsWithAnyNumberOfThreads)
{
    const Frame frame = frames::ring(GetParam());
    const DeformationSession session(frame.assembly);
    const auto drag = session.begin_drag({"tip"});
    drag->wait();
    const Deformed several = *drag->frame(frame.pose);
    const ThreadCount one(1);
    EXPECT_EQ(worst_share(frame, *drag->frame(frame.pose), several), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, LiveDragContacts,
                         testing::Values(ContactType::rigid, ContactType::tied,
                                         ContactType::control_mesh));

// A chain: its first plate is dragged, the others follow through contacts.
TEST_P(LiveDragContacts, ThinSolidsAnswerWithBothSkins)
{
    const Frame frame = frames::thin_solids(frames::open_chain(GetParam()));
    const DeformationSession session(frame.assembly);
    const Deformed exact = session.deform(frame.pose);
    const auto drag = session.begin_drag({"tip"}, {}, learning);
    EXPECT_LT(worst_share(frame, *drag->frame(frame.pose), exact), 1e-6);
    drag->wait();
    const Deformed live = *drag->frame(frame.pose);
    EXPECT_LT(worst_share(frame, live, exact), 1e-6);
    for (std::size_t part = 0; part < live.parts.size(); ++part)
    {
        ASSERT_NE(session.thin_solid(static_cast<int>(part)), nullptr);
        EXPECT_GT((live.parts[part].positions - frame.assembly.parts[part].mesh.points()).norm(),
                  1e-3);
    }
    EXPECT_TRUE(drag->answered()[0]);
}

class LearntDrag : public testing::TestWithParam<std::tuple<ContactType, surface::FeatureRotation>>
{
};

// Poses all over what a drag learns from, none of them among those.
TEST_P(LearntDrag, PartsBehindContactsAnswerWithoutSubstitution)
{
    const auto [type, rotation] = GetParam();
    Frame frame = frames::ring(type);
    for (PartFeature& feature : frame.assembly.features)
        feature.rotation = rotation;
    const DeformationSession session(frame.assembly);
    const auto drag = session.begin_drag({"tip"}, {}, learning);
    drag->wait();
    for (int k = 0; k < 8; ++k)
    {
        Pose pose = frame.pose;
        const Vector3 axis(std::sin(1.0 + k), std::cos(2.0 * k), std::sin(3.0 * k));
        pose.handles["tip"] =
            frames::motion(20.0 * Vector3(std::cos(k), std::sin(2.0 * k), 1.0), axis.normalized(),
                           7.0 * k, frame.pose.handles.at("tip").pivot);
        const Deformed live = *drag->frame(pose);
        EXPECT_LT(worst_share(frame, live, session.deform(pose)), 1e-6) << k;
        EXPECT_EQ(drag->answered(), (std::vector<char>{1, 1, 1, 1})) << k;
    }
}

TEST(LiveDrag, SmallAssembliesAreSubstitutedBehindContacts)
{
    const Frame frame = frames::ring(ContactType::control_mesh);
    const DeformationSession session(frame.assembly);
    const auto drag = session.begin_drag({"tip"});
    drag->wait();
    EXPECT_LT(worst_share(frame, *drag->frame(frame.pose), session.deform(frame.pose)), 1e-6);
    EXPECT_EQ(drag->answered(), (std::vector<char>{1, 0, 0, 0}));
}

INSTANTIATE_TEST_SUITE_P(All, LearntDrag,
                         testing::Combine(testing::Values(ContactType::tied,
                                                          ContactType::control_mesh),
                                          testing::Values(surface::FeatureRotation::interpolated,
                                                          surface::FeatureRotation::free)));

TEST(LiveDrag, SubstitutesWhereAPoseIsFarFromThoseLearntFrom)
{
    const Frame frame = frames::ring(ContactType::control_mesh);
    const DeformationSession session(frame.assembly);
    const auto drag = session.begin_drag({"tip"}, {}, learning);
    drag->wait();
    Pose pose = frame.pose;
    pose.handles["tip"].rotation_log = rotation_log(Vector3::UnitX(), 7.0);
    const Deformed far = *drag->frame(pose);
    EXPECT_FALSE(drag->answered()[0]);
    EXPECT_LT(worst_share(frame, far, session.deform(pose)), 1e-6);
}

TEST(LiveDrag, RigidlyWeldedPartsAnswerToo)
{
    const Frame frame = frames::ring(ContactType::rigid);
    const auto drag = DeformationSession(frame.assembly).begin_drag({"tip"}, {}, learning);
    drag->wait();
    drag->frame(frame.pose);
    // Two welds move the third plate, about different axes.
    EXPECT_EQ(drag->answered(), (std::vector<char>{1, 1, 1, 1}));
}

TEST(LiveDrag, TakesTheExactPathWhereAPoseIsNotOfItsForm)
{
    const Frame frame = frames::ring(ContactType::rigid);
    const DeformationSession session(frame.assembly);
    const auto drag = session.begin_drag({"tip"}, {}, learning);
    drag->wait();
    Pose pose = frame.pose;
    pose.handles["tip"].rotation_log *= 10.0;
    const Deformed far = *drag->frame(pose);
    EXPECT_FALSE(drag->answered()[0]);
    EXPECT_LT(worst_share(frame, far, session.deform(pose)), 1e-6);
}

TEST_P(LiveDragContacts, AFrameThatIsHeldStaysAsItIs)
{
    const Frame frame = frames::ring(GetParam());
    const auto drag = DeformationSession(frame.assembly).begin_drag({"tip"}, {}, learning);
    std::vector<std::shared_ptr<const Deformed>> held;
    std::vector<Deformed> copies;
    Pose pose = frame.pose;
    // Some by substitution, more by what is learnt.
    for (int step = 0; step < 8; ++step)
    {
        if (step == 4)
            drag->wait();
        pose.handles["tip"].translation.z() += 3.0;
        held.push_back(drag->frame(pose));
        copies.push_back(*held.back());
    }
    for (std::size_t step = 0; step < held.size(); ++step)
        EXPECT_EQ(worst_share(frame, *held[step], copies[step]), 0.0) << step;
}

TEST(LiveDrag, TheMemoryOfFramesThatNobodyHoldsIsUsedAgain)
{
    const Frame frame = frames::ring(ContactType::rigid);
    const auto drag = DeformationSession(frame.assembly).begin_drag({"tip"}, {}, learning);
    drag->wait();
    std::set<const Deformed*> seen;
    std::shared_ptr<const Deformed> shown;
    for (int step = 0; step < 10; ++step)
    {
        shown = drag->frame(frame.pose);
        seen.insert(shown.get());
    }
    EXPECT_LE(seen.size(), 2U);
}

TEST(LiveDrag, AnErrorOfTheLearningIsToldWithoutWaitingAndFramesGoOn)
{
    const Frame frame = frames::ring(ContactType::rigid);
    const DeformationSession session(frame.assembly);
    DragOptions failing = learning;
    failing.progress =
        Progress([](double, const std::string&) -> bool { throw SolverError("no unique answer"); });
    const auto drag = session.begin_drag({"tip"}, {}, failing);
    EXPECT_THROW(drag->wait(), SolverError);
    EXPECT_EQ(drag->failure(), "no unique answer");
    EXPECT_LT(worst_share(frame, *drag->frame(frame.pose), session.deform(frame.pose)), 1e-6);
    const auto sound = session.begin_drag({"tip"}, {}, learning);
    sound->wait();
    EXPECT_EQ(sound->failure(), "");
}

TEST(LiveDrag, FramesOfRefinedPartsArePreviews)
{
    Frame frame = frames::ring(ContactType::tied);
    for (const bool is_refined : {false, true})
    {
        frame.assembly.is_refined = is_refined;
        const DeformationSession session(frame.assembly);
        const auto drag = session.begin_drag({"tip"}, {}, learning);
        const auto early = drag->frame(frame.pose);
        drag->wait();
        const auto late = drag->frame(frame.pose);
        const Deformed exact = session.deform(frame.pose);
        for (std::size_t part = 0; part < exact.parts.size(); ++part)
        {
            EXPECT_EQ(early->parts[part].is_preview, is_refined);
            EXPECT_EQ(late->parts[part].is_preview, is_refined);
            EXPECT_FALSE(exact.parts[part].is_preview);
        }
    }
}

TEST(LiveDrag, MayEndBeforeItsResponsesAreThere)
{
    const Frame frame = frames::ring(ContactType::rigid);
    const DeformationSession session(frame.assembly);
    EXPECT_NO_THROW(session.begin_drag({"tip"}));
}

TEST(LiveDrag, RefusesHandlesTheAssemblyDoesNotHave)
{
    const DeformationSession session(frames::ring(ContactType::rigid).assembly);
    EXPECT_THROW(session.begin_drag({"nose"}), InvalidInput);
}

}  // namespace
}  // namespace sheetmorph::assembly

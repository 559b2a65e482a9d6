// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/deformation_session.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/volume/local_rotations.h"
#include "assembly/all_frames.h"
#include "assembly/gap_change.h"

#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

using frames::Frame;

TEST(DeformationSession, PartsThatNothingReachesStayBitForBit)
{
    Frame frame = frames::ring(ContactType::control_mesh);
    frame.assembly.contacts.resize(1);
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    for (const std::size_t part : {2, 3})
        EXPECT_EQ(shape.parts[part].positions, frame.assembly.parts[part].mesh.points());
}

TEST(DeformationSession, ARigidContactKeepsItsGapToRounding)
{
    const Frame frame = frames::ring(ContactType::rigid);
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    ASSERT_EQ(shape.contacts.size(), 4U);
    for (const ContactFidelity& contact : shape.contacts)
    {
        EXPECT_LT(frames::gap_change(frame.assembly, contact, shape), 1e-11);
        EXPECT_LT(contact.deviation, 1e-10);
    }
}

TEST(DeformationSession, ATiedContactKeepsItsGapWhereNoFeatureIsStiffer)
{
    Frame frame = frames::open_chain(ContactType::tied);
    frame.assembly.features.clear();
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    for (const ContactFidelity& contact : shape.contacts)
    {
        EXPECT_LT(frames::gap_change(frame.assembly, contact, shape), 1e-6 * 480.0);
        EXPECT_GT(contact.deviation, 0.01);  // the region itself bends
    }
}

TEST(DeformationSession, AControlMeshContactKeepsItsGapWithinHalfAPercentOfTheRegion)
{
    Frame frame = frames::open_chain(ContactType::control_mesh);
    frame.pose.handles["tip"] = frames::motion({-1, 0, 6}, {0, 1, 0}, 8.0, {180, 30, 0});
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    for (const ContactFidelity& contact : shape.contacts)
        EXPECT_LT(frames::gap_change(frame.assembly, contact, shape), 0.005 * contact.region_size);
}

TEST(DeformationSession, OverlappingTiedTargetsTakeTheirMeanAndReportTheSpread)
{
    const Frame frame = frames::ring(ContactType::tied);
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    EXPECT_GT(shape.spread, 0.0);
    EXPECT_LT(shape.spread, 5.0);
    EXPECT_LT(DeformationSession(frame.assembly).deform({}).spread, 1e-12);
}

TEST(DeformationSession, WeldsBetweenTheSamePartsOverOneFeatureAreOneBody)
{
    Frame frame = frames::ring(ContactType::rigid);
    frame.assembly.contacts.resize(1);
    Contact again = frame.assembly.contacts[0];
    again.name = "again";
    again.a.vertices = {frame.assembly.contacts[0].a.vertices[0]};
    frame.assembly.contacts.push_back(again);
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    for (const ContactFidelity& contact : shape.contacts)
        EXPECT_LT(frames::gap_change(frame.assembly, contact, shape), 1e-11);
}

TEST(DeformationSession, FixedAndFeaturesOfTheTargetComeBeforeItsContact)
{
    Frame frame = frames::open_chain(ContactType::tied);
    const int pinned = frame.assembly.contacts[0].b.vertices[1];
    frame.assembly.fixed.push_back({"pin", 1, {pinned}});
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    EXPECT_EQ(shape.parts[1].positions.row(pinned),
              frame.assembly.parts[1].mesh.points().row(pinned));
}

TEST(DeformationSession, APrescribedFeatureInAContactTurnsAsToldAndGoesWhereTheContactGoes)
{
    Frame frame = frames::open_chain(ContactType::tied);
    const Deformed before = DeformationSession(frame.assembly).deform(frame.pose);
    // The hole of the second plate in the contact.
    frame.assembly.features[3].rotation = surface::FeatureRotation::prescribed;
    const Vector3 log = rotation_log({0.0, 0.0, 1.0}, 0.5);
    frame.pose.feature_logs["second hole0"] = log;
    const Deformed after = DeformationSession(frame.assembly).deform(frame.pose);
    EXPECT_LT((after.features[3].motion.rotation() - rotation_from_log(log)).norm(), 1e-12);
    EXPECT_LT((after.features[3].motion.translation - before.features[3].motion.translation).norm(),
              6.0);
    EXPECT_GT(before.features[3].motion.translation.norm(), 10.0);
}

TEST(DeformationSession, ASingleControlMeshIgnoresContactsButTellsHowTheyFared)
{
    const Frame frame = frames::single(Mode::automatic);
    const DeformationSession session(frame.assembly);
    EXPECT_TRUE(session.plan().contacts.empty());
    EXPECT_EQ(session.deform(frame.pose).contacts.size(), 4U);
}

TEST(DeformationSession, APartOnOneVertexTurnsAsTheSheetThereAlsoNearAWholeTurn)
{
    for (const ContactType type : {ContactType::control_mesh, ContactType::tied})
    {
        Frame frame = frames::small_contacts(type, false);
        frame.assembly.contacts.resize(1);
        frame.assembly.features.clear();
        const DeformationSession session(frame.assembly);
        const int a = frame.assembly.contacts[0].a.vertices[0];
        for (const double degrees : {300.0, 340.0, 356.0, 370.0})
        {
            frame.pose.handles["tip"] =
                frames::motion(Vector3::Zero(), {0.2, 1.0, 0.1}, degrees, {180, 30, 0});
            const Deformed shape = session.deform(frame.pose);
            const Points& rest = frame.assembly.parts[1].mesh.points();
            const RigidMotion moved = best_rigid_motion(rest, shape.parts[1].positions);
            const volume::LocalRotations sheet =
                volume::LocalRotationMeter(frame.assembly.parts[0].mesh, {a})
                    .measure(shape.parts[0].positions, shape.parts[0].rotation_logs.row(a));
            EXPECT_LT((moved.rotation() - sheet.matrices[0]).norm(), 1e-6) << degrees;
        }
    }
}

TEST(DeformationSession, TiedComesBeforeControlMeshOnOneVertex)
{
    Frame frame = frames::ring(ContactType::control_mesh);
    frame.assembly.features.clear();
    frame.assembly.contacts[1].type = ContactType::tied;
    const Deformed both = DeformationSession(frame.assembly).deform(frame.pose);
    Frame alone = frame;
    alone.assembly.contacts.pop_back();  // without fourth - third
    const Deformed tied = DeformationSession(alone.assembly).deform(alone.pose);
    for (const int vertex : frame.assembly.contacts[1].b.vertices)
        EXPECT_EQ(both.parts[2].positions.row(vertex), tied.parts[2].positions.row(vertex));
}

TEST(DeformationSession, ChangingOneContactRebuildsOnlyWhatDependsOnIt)
{
    Frame frame = frames::open_chain(ContactType::control_mesh);
    const DeformationSession before(frame.assembly);
    EXPECT_EQ(before.timings().size(), 4U + 3U);
    frame.assembly.contacts[1].type = ContactType::tied;
    const DeformationSession after(frame.assembly, {}, &before);
    EXPECT_EQ(after.timings().size(), 1U);  // the new link; its part's matrix is the same
    const Deformed expected = DeformationSession(frame.assembly).deform(frame.pose);
    const Deformed found = after.deform(frame.pose);
    for (std::size_t k = 0; k < expected.parts.size(); ++k)
        EXPECT_EQ(found.parts[k].positions, expected.parts[k].positions);
    frame.assembly.fixed.front().vertices.pop_back();
    EXPECT_EQ(DeformationSession(frame.assembly, {}, &after).timings().size(), 1U);
}

TEST(DeformationSession, EditedConstraintsGiveTheSameShapesAsAFreshStart)
{
    Frame frame = frames::open_chain(ContactType::control_mesh);
    const DeformationSession before(frame.assembly);
    frame.assembly.fixed.front().vertices.pop_back();
    frame.assembly.features.pop_back();
    const DeformationSession after(frame.assembly, {}, &before);
    const Deformed found = after.deform(frame.pose);
    const Deformed expected = DeformationSession(frame.assembly).deform(frame.pose);
    for (std::size_t k = 0; k < expected.parts.size(); ++k)
        EXPECT_LT((found.parts[k].positions - expected.parts[k].positions).cwiseAbs().maxCoeff(),
                  1e-9 * frame.assembly.parts[k].mesh.size());
}

TEST(DeformationSession, ShowsTheControlMeshOfAContactAsItMoves)
{
    const Frame frame = frames::open_chain(ContactType::control_mesh);
    const DeformationSession session(frame.assembly);
    const auto rest = session.control_mesh(0, session.deform({}));
    const auto moved = session.control_mesh(0, session.deform(frame.pose));
    ASSERT_TRUE(rest && moved);
    EXPECT_EQ(rest->vertices.rows(), 386);
    EXPECT_EQ(rest->triangles.rows(), 768);
    EXPECT_GT((moved->vertices - rest->vertices).rowwise().norm().maxCoeff(), 5.0);
    EXPECT_FALSE(session.control_mesh(99, session.deform({})).has_value());
}

TEST(DeformationSession, CancelsBetweenPartsAndReportsRisingProgress)
{
    const Assembly assembly = frames::ring(ContactType::control_mesh).assembly;
    double last = 0.0;
    DeformationSession(assembly, Progress(
                                     [&](double fraction, const std::string&)
                                     {
                                         EXPECT_GE(fraction, last);
                                         last = fraction;
                                         return true;
                                     }));
    EXPECT_EQ(last, 1.0);
    EXPECT_THROW(
        DeformationSession(assembly, Progress([](double, const std::string&) { return false; })),
        Cancelled);
}

}  // namespace
}  // namespace sheetmorph::assembly

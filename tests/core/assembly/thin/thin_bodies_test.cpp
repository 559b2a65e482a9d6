// SPDX-License-Identifier: LGPL-2.1-or-later
// The sheet in the middle of a thin solid has bodies that the whole solid does not have: contacts
// that a fixed region holds, and loose pieces that go along.
#include "sheetmorph/assembly/session/live_drag.h"

#include "sheetmorph/base/errors.h"
#include "assembly/frames.h"
#include "assembly/thin_frames.h"
#include "shapes/growing_mesh.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

using frames::Frame;

VertexIds patch(const mesh::TriangleMesh& mesh, shapes::Draw& draw)
{
    const Vector3 centre = mesh.points().row(draw.whole(mesh.vertex_count())).transpose();
    const double radius = draw.one_of<double>({0.1, 12.0, 40.0, 400.0});
    return shapes::vertices_where(mesh,
                                  [&](const Vector3& p) { return (p - centre).norm() <= radius; });
}

void add_regions(Frame& frame, shapes::Draw& draw)
{
    Assembly& assembly = frame.assembly;
    const auto part = [&] { return draw.whole(static_cast<int>(assembly.parts.size())); };
    if (draw.happens(0.3))
        assembly.features.clear();
    for (int count = draw.whole(6); count > 0; --count)
    {
        PartFeature feature;
        feature.name = "drawn" + std::to_string(count);
        feature.part = part();
        feature.vertices = patch(assembly.parts[static_cast<std::size_t>(feature.part)].mesh, draw);
        assembly.features.push_back(feature);
    }
    for (int count = draw.whole(3); count > 0; --count)
    {
        PartRegion fixed{"held" + std::to_string(count), part(), {}};
        if (fixed.part == assembly.handles[0].part)
            continue;
        fixed.vertices = patch(assembly.parts[static_cast<std::size_t>(fixed.part)].mesh, draw);
        assembly.fixed.push_back(fixed);
    }
}

// A piece of its own, before the part becomes solid.
void add_island(Part& part, shapes::Draw& draw)
{
    shapes::GrowingMesh mesh(part.mesh);
    mesh.add_island(draw);
    part.mesh = mesh.mesh();
}

// A ring of thin solids with form features and fixed regions anywhere, which may overlap each other
// and contacts, and with loose pieces.
Frame drawn_ring(unsigned seed)
{
    shapes::Draw draw(seed);
    const auto type = draw.one_of<ContactType>({ContactType::rigid, ContactType::tied});
    Frame frame = frames::ring(type);
    for (Part& part : frame.assembly.parts)
        if (draw.happens(0.4))
            add_island(part, draw);
    frame = frames::thin_solids(frame);
    frame.assembly.unheld = draw.one_of<Unheld>({Unheld::along, Unheld::rest});
    if (draw.happens(0.7))
        for (Contact& contact : frame.assembly.contacts)
            contact.type = draw.one_of<ContactType>({type, ContactType::rigid});
    add_regions(frame, draw);
    return frame;
}

// A motion that nobody has set has its pivot anywhere.
void expect_sound(const DeformationSession& session, const Deformed& shape)
{
    for (std::size_t k = 0; k < shape.parts.size(); ++k)
    {
        const Part& part = session.assembly().parts[k];
        Eigen::AlignedBox3d box;
        for (const auto& point : part.mesh.points().rowwise())
            box.extend(Vector3(point.transpose()));
        EXPECT_TRUE(shape.parts[k].positions.allFinite()) << part.name;
        for (const RigidMotion& motion : shape.parts[k].features)
            EXPECT_LT(box.exteriorDistance(motion.pivot), 1e-9 * box.diagonal().norm())
                << part.name;
    }
}

void expect_sound_in_every_way(const Frame& frame)
{
    const DeformationSession session(frame.assembly);
    expect_sound(session, session.deform(frame.pose));
    const auto drag = session.begin_drag({"tip"}, frame.pose, {0, {}});
    expect_sound(session, *drag->frame(frame.pose));
    drag->wait();
    expect_sound(session, *drag->frame(frame.pose));
}

TEST(ThinBodies, AContactThatIsHeldIsNoBodyOfTheWholeSolid)
{
    Frame frame = frames::thin_solids(frames::ring(ContactType::rigid));
    frame.assembly.features.clear();
    const PartRegion& side = frame.assembly.contacts[1].b;  // of a part without any other body
    frame.assembly.fixed.push_back({"held", side.part, side.vertices});
    expect_sound_in_every_way(frame);
}

TEST(ThinBodies, ALoosePieceThatGoesAlongIsNoBodyOfTheWholeSolid)
{
    Frame frame = frames::ring(ContactType::tied);
    shapes::Draw draw(1);
    add_island(frame.assembly.parts[2], draw);
    frame = frames::thin_solids(frame);
    frame.assembly.features.clear();
    frame.assembly.unheld = Unheld::along;
    EXPECT_FALSE(DeformationSession(frame.assembly).loose_pieces().empty());
    expect_sound_in_every_way(frame);
}

TEST(ThinBodies, AnyAssemblyIsAnsweredOrRefused)
{
    int answered = 0;
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        SCOPED_TRACE(seed);
        try
        {
            expect_sound_in_every_way(drawn_ring(seed));
            ++answered;
        }
        catch (const InvalidInput&)
        {
            continue;
        }
    }
    EXPECT_GT(answered, 5);
}

}  // namespace
}  // namespace sheetmorph::assembly

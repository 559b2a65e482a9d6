// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/live_drag.h"
#include "sheetmorph/mesh/topology/submesh.h"
#include "assembly/all_frames.h"
#include "assembly/gap_change.h"
#include "assembly/refusals.h"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <set>

namespace sheetmorph::assembly
{

using namespace mesh;
using namespace surface;
namespace
{

using frames::Frame;

Frame whole(Frame frame)
{
    frame.assembly.propagation.type = PropagationType::whole;
    return frame;
}

// The middle of the first plate is moved; the far ends of others are held.
Frame held_elsewhere(ContactType type)
{
    Frame frame = whole(frames::ring(type));
    Assembly& assembly = frame.assembly;
    assembly.fixed = {
        frames::side("end", assembly, 2, [](const Vector3& p) { return p.x() > 480.0 - 1e-6; })};
    const PartRegion tip =
        frames::side("tip", assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; });
    assembly.handles = {{tip.name, tip.part, tip.vertices}};
    for (PartFeature& feature : assembly.features)
        feature.rotation = FeatureRotation::free;
    frame.pose.handles["tip"] = frames::motion({4.0, 0.0, 25.0}, {0.0, 1.0, 0.0}, 10.0, {0, 0, 0});
    return frame;
}

double farthest(const Deformed& a, const Deformed& b)
{
    double worst = 0.0;
    for (std::size_t part = 0; part < a.parts.size(); ++part)
        worst = std::max(
            worst, (a.parts[part].positions - b.parts[part].positions).rowwise().norm().maxCoeff());
    return worst;
}

double worst_edge_error(const Deformed& shape)
{
    double worst = 0.0;
    for (const FeatureResult& feature : shape.features)
        worst = std::max(worst, feature.edge_error);
    return worst;
}

// A plate with round holes, and the same cut between two of its cells, the cut welded.
struct CutPlate
{
    explicit CutPlate(Energy energy)
    {
        const shapes::PlateWithHoles plate = shapes::plate_with_holes({3, 16, 3, 60.0, 12.0});
        one.energy = halves.energy = energy;
        halves.propagation.type = PropagationType::whole;
        one.parts.push_back({"plate", plate.mesh, {}});
        places.resize(2);
        for (const bool is_right : {false, true})
            cut(plate, is_right);
        for (Assembly* assembly : {&one, &halves})
            hold(*assembly);
        const auto at_cut = [](const Vector3& p) { return std::abs(p.x() - 60.0) < 1e-6; };
        Contact weld;
        weld.name = "weld";
        weld.type = ContactType::tied;
        weld.a = frames::side("a", halves, 0, at_cut);
        weld.b = frames::side("b", halves, 1, at_cut);
        halves.contacts.push_back(weld);
    }

    // The cells on one side of the cut, with the vertices of the plate they have.
    void cut(const shapes::PlateWithHoles& plate, bool is_right)
    {
        const Points& points = plate.mesh.points();
        std::vector<int> triangles;
        for (int t = 0; t < plate.mesh.triangle_count(); ++t)
        {
            const Eigen::RowVector3i corners = plate.mesh.triangles().row(t);
            const double middle =
                (points(corners(0), 0) + points(corners(1), 0) + points(corners(2), 0)) / 3.0;
            if ((middle > 60.0) == is_right)
                triangles.push_back(t);
        }
        const Submesh half = submesh(plate.mesh, triangles);
        places[is_right ? 1 : 0] = half.vertices;
        halves.parts.push_back({is_right ? "right" : "left", half.mesh, {}});
        for (std::size_t k = 0; k < plate.rims.size(); ++k)
            add_hole("hole" + std::to_string(k), plate.rims[k], half, is_right);
    }

    void add_hole(const std::string& name, const VertexIds& rim, const Submesh& half, bool is_right)
    {
        PartFeature hole;
        hole.name = name;
        hole.vertices = rim;
        if (!is_right)
            one.features.push_back(hole);
        for (int& vertex : hole.vertices)
            vertex = half.index_of[static_cast<std::size_t>(vertex)];
        hole.part = is_right ? 1 : 0;
        if (hole.vertices.front() >= 0)
            halves.features.push_back(hole);
    }

    void hold(Assembly& assembly)
    {
        const int last = static_cast<int>(assembly.parts.size()) - 1;
        assembly.fixed = {
            frames::side("root", assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; })};
        const PartRegion tip = frames::side("tip", assembly, last,
                                            [](const Vector3& p) { return p.x() > 180.0 - 1e-6; });
        assembly.handles = {{tip.name, tip.part, tip.vertices}};
        pose.handles["tip"] =
            frames::motion({-3.0, 5.0, 30.0}, {0.3, 1.0, 0.2}, 35.0, {180, 30, 0});
    }

    Assembly one, halves;
    std::vector<VertexIds> places;  // of the plate, by half
    Pose pose;
};

class CutPlates : public testing::TestWithParam<Energy>
{
};

TEST_P(CutPlates, AnswerAsThePlateDidWhenTheCutIsWelded)
{
    const CutPlate plate(GetParam());
    const Deformed one = DeformationSession(plate.one).deform(plate.pose);
    const Deformed halves = DeformationSession(plate.halves).deform(plate.pose);
    for (std::size_t half = 0; half < 2; ++half)
        for (std::size_t k = 0; k < plate.places[half].size(); ++k)
            EXPECT_LT((halves.parts[half].positions.row(static_cast<Eigen::Index>(k))
                       - one.parts[0].positions.row(plate.places[half][k]))
                          .norm(),
                      1e-7);
}

INSTANTIATE_TEST_SUITE_P(Energies, CutPlates,
                         testing::Values(Energy::neumann, Energy::paper, Energy::natural));

class WholeAssemblies : public testing::TestWithParam<ContactType>
{
};

TEST_P(WholeAssemblies, AreHeldByWhatIsHeldOnAnyPart)
{
    const Frame frame = held_elsewhere(GetParam());
    const DeformationSession session(frame.assembly);
    EXPECT_TRUE(session.is_held(0));
    const Deformed shape = session.deform(frame.pose);
    const PartRegion& end = frame.assembly.fixed.front();
    for (const int vertex : end.vertices)
        EXPECT_EQ(shape.parts[2].positions.row(vertex),
                  frame.assembly.parts[2].mesh.points().row(vertex));
    EXPECT_LT(worst_edge_error(shape), 1e-9);
    ASSERT_EQ(shape.contacts.size(), 4u);
    for (const ContactFidelity& contact : shape.contacts)
        EXPECT_LT(frames::gap_change(frame.assembly, contact, shape),
                  GetParam() == ContactType::rigid ? 1e-9 : 0.1);
    // The first plate bends: its right end does not go where the handle would take it.
    const Points& first = shape.parts[0].positions;
    double miss = 0.0;
    for (int vertex = 0; vertex < first.rows(); ++vertex)
        miss = std::max(miss, (frame.pose.handles.at("tip").apply(
                                   Vector3(frame.assembly.parts[0].mesh.points().row(vertex)))
                               - first.row(vertex).transpose())
                                  .norm());
    EXPECT_GT(miss, 5.0);
}

TEST_P(WholeAssemblies, DoNotAskWhichPartIsThePrimaryNorForAnOrder)
{
    const Frame frame = held_elsewhere(GetParam());
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    Frame other = frame;
    other.assembly.primary = 2;
    for (Contact& contact : other.assembly.contacts)
        std::swap(contact.a, contact.b);
    EXPECT_LT(farthest(shape, DeformationSession(other.assembly).deform(frame.pose)), 1e-9);
}

TEST_P(WholeAssemblies, AnswerLiveAsExactly)
{
    for (const Frame& frame :
         {held_elsewhere(GetParam()), whole(frames::thin_solids(frames::open_chain(GetParam())))})
    {
        const DeformationSession session(frame.assembly);
        const double size = 500.0;
        const Deformed exact = session.deform(frame.pose);
        EXPECT_LT(farthest(session.deform(frame.pose, Exactness::live), exact), 1e-6 * size);
        const auto drag = session.begin_drag({"tip"}, {}, {0, {}});
        drag->wait();
        EXPECT_LT(farthest(*drag->frame(frame.pose), exact), 1e-6 * size) << frame.name;
        EXPECT_TRUE(drag->answered()[0] && drag->answered()[1]) << frame.name;
        EXPECT_LT(worst_edge_error(exact), 1e-9) << frame.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Contacts, WholeAssemblies,
                         testing::Values(ContactType::rigid, ContactType::tied,
                                         ContactType::control_mesh));

TEST(Whole, TellsWhatItCannotSolve)
{
    Frame frame = held_elsewhere(ContactType::tied);
    frame.assembly.energy = Energy::steel;
    EXPECT_NE(refusal(frame).find("'steel'"), std::string::npos);

    Frame thin = whole(frames::thin_solids(frames::open_chain(ContactType::tied)));
    PartPoint point;
    point.name = "pin";
    point.constraint.barycentric = {1.0, 0.0, 0.0};
    thin.assembly.points = {point};
    EXPECT_NE(refusal(thin).find("part 'first': point 'pin' lies on a thin solid"),
              std::string::npos);

    Frame torn = held_elsewhere(ContactType::rigid);
    torn.assembly.fixed = {torn.assembly.contacts[0].b};
    torn.assembly.fixed.front().name = "ground";
    torn.assembly.handles.front().vertices = torn.assembly.contacts[0].a.vertices;
    EXPECT_NE(refusal(torn).find("touches both a fixed region and handle 'tip'"), std::string::npos)
        << refusal(torn);
}

// Three sheets on each other whose vertices do not match, each tied to both others.
Frame layers()
{
    Frame frame;
    Assembly& assembly = frame.assembly;
    assembly.propagation.type = PropagationType::whole;
    for (int layer = 0; layer < 3; ++layer)
    {
        const TriangleMesh grid = shapes::grid(40 + 7 * layer, 4 + layer, 200.0, 20.0);
        const auto lifted = [&](const Vector3& p) { return Vector3(p + Vector3(0.0, 0.0, layer)); };
        assembly.parts.push_back(
            {"layer" + std::to_string(layer), shapes::mapped(grid, lifted), {}});
    }
    const auto all = [](const Vector3&) { return true; };
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)})
    {
        Contact contact;
        contact.name = "seam" + std::to_string(a) + std::to_string(b);
        contact.type = ContactType::tied;
        contact.a = frames::side("a", assembly, a, all);
        contact.b = frames::side("b", assembly, b, all);
        assembly.contacts.push_back(contact);
    }
    assembly.fixed = {
        frames::side("root", assembly, 0, [](const Vector3& p) { return p.x() < 1e-6; })};
    const PartRegion tip =
        frames::side("tip", assembly, 2, [](const Vector3& p) { return p.x() > 200.0 - 1e-6; });
    assembly.handles = {{tip.name, tip.part, tip.vertices}};
    frame.pose.handles["tip"] =
        frames::motion({-10.0, 0.0, 30.0}, {0.0, 1.0, 0.0}, -30.0, {200, 10, 2});
    return frame;
}

TEST(Whole, LayersOfOneSeamAreNotOneRigidBody)
{
    const Frame frame = layers();
    const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
    // The first and the last one stand on the one between; the chord of a triangle is told there.
    for (const ContactFidelity& contact : shape.contacts)
        EXPECT_LT(frames::gap_change(frame.assembly, contact, shape),
                  contact.contact == 2 ? 0.03 : 1e-9);
    // Every layer is bent all along: no chord is as long as the sheet.
    for (std::size_t layer = 0; layer < 3; ++layer)
    {
        const Points& now = shape.parts[layer].positions;
        const auto last = static_cast<Eigen::Index>(40 + 7 * layer);
        const Vector3 a = now.row(0).transpose(), b = now.row(last).transpose();
        const Vector3 middle = now.row(last / 2).transpose();
        EXPECT_GT((middle - 0.5 * (a + b)).norm(), 1.0);
    }
}

struct Hold
{
    std::string name;
    ContactType type;
    double roll;  // of the sheets, radians in 1 mm: 0 is flat
    std::function<bool(const Vector3&)> is_there;
};

void PrintTo(const Hold& hold, std::ostream* out)
{
    *out << hold.name;
}

// Two strips on each other, flat or rolled up, one of them held; the other one hangs on a few
// vertices of it.
Frame hanging(const Hold& hold, Energy energy)
{
    const TriangleMesh grid = shapes::grid(12, 6, 60.0, 20.0);
    Frame frame;
    Assembly& assembly = frame.assembly;
    assembly.energy = energy;
    assembly.propagation.type = PropagationType::whole;
    for (const double lift : {0.0, 1.0})
    {
        const auto laid = [&](const Vector3& p)
        {
            if (hold.roll == 0.0)
                return Vector3(p.x(), p.y(), lift);
            const double radius = 1.0 / hold.roll + lift, turn = hold.roll * p.x();
            return Vector3(radius * std::sin(turn), p.y(), radius * std::cos(turn));
        };
        assembly.parts.push_back(
            {"strip" + std::to_string(assembly.parts.size()), shapes::mapped(grid, laid), {}});
    }
    Contact contact;
    contact.name = "hold";
    contact.type = hold.type;
    for (int i = 0; i < grid.vertex_count(); ++i)
        if (hold.is_there(grid.points().row(i)))
            contact.a.vertices.push_back(i);
    contact.a.part = 0;
    contact.b = {"", 1, contact.a.vertices};
    assembly.contacts.push_back(contact);
    VertexIds tip;
    for (int i = 0; i < grid.vertex_count(); ++i)
        if (grid.points()(i, 0) > 60.0 - 1e-6)
            tip.push_back(i);
    assembly.handles = {{"tip", 0, tip}};
    return frame;
}

class HangingSheets : public testing::TestWithParam<Hold>
{
};

TEST_P(HangingSheets, TurnWithWhatHoldsThemByEveryEnergy)
{
    for (const auto& [energy, type] : {std::pair(Energy::neumann, PropagationType::whole),
                                       std::pair(Energy::paper, PropagationType::whole),
                                       std::pair(Energy::natural, PropagationType::whole),
                                       std::pair(Energy::natural, PropagationType::local)})
    {
        Frame frame = hanging(GetParam(), energy);
        frame.assembly.propagation.type = type;
        const RigidMotion motion =
            frames::motion({3.0, -5.0, 8.0}, {1.0, 2.0, -1.0}, 25.0, {0, 0, 0});
        frame.pose.handles["tip"] = motion;
        const Deformed shape = DeformationSession(frame.assembly).deform(frame.pose);
        for (std::size_t part = 0; part < 2; ++part)
        {
            const Points& rest = frame.assembly.parts[part].mesh.points();
            for (Eigen::Index i = 0; i < rest.rows(); ++i)
                EXPECT_LT((motion.apply(Vector3(rest.row(i)))
                           - shape.parts[part].positions.row(i).transpose())
                              .norm(),
                          1e-6);
        }
    }
}

const auto one_place = [](const Vector3& p) { return (p - Vector3(30, 10, 0)).norm() < 1.0; };
const auto across = [](const Vector3& p) { return std::abs(p.x() - 30.0) < 1.0; };
const auto along = [](const Vector3& p) { return std::abs(p.y() - 10.0) < 1.0; };
const auto far_apart = [](const Vector3& p)
{ return std::abs(p.x() - 30.0) < 1.0 && (p.y() < 1.0 || p.y() > 19.0); };

INSTANTIATE_TEST_SUITE_P(
    Holds, HangingSheets,
    testing::Values(Hold{"one vertex welded", ContactType::rigid, 0.0, one_place},
                    Hold{"two vertices welded", ContactType::rigid, 0.0, far_apart},
                    Hold{"a row welded", ContactType::rigid, 0.0, along},
                    Hold{"a row welded along a tube", ContactType::rigid, 0.1, along},
                    Hold{"a row welded around a tube", ContactType::rigid, 0.1, across},
                    Hold{"one vertex tied", ContactType::tied, 0.0, one_place},
                    Hold{"two vertices tied", ContactType::tied, 0.0, far_apart},
                    Hold{"a row tied along a tube", ContactType::tied, 0.1, along},
                    Hold{"a row tied around a tube", ContactType::tied, 0.1, across}));

}  // namespace
}  // namespace sheetmorph::assembly

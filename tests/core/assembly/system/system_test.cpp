// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/system.h"

#include "sheetmorph/assembly/session/deformation_session.h"
#include "sheetmorph/mesh/topology/submesh.h"
#include "assembly/drawn_assembly.h"

#include <gtest/gtest.h>
#include <numeric>

namespace sheetmorph::assembly
{
namespace
{

System system_of(const Assembly& assembly)
{
    const std::vector<char> is_thin(assembly.parts.size(), 0);
    std::deque<mesh::PartGeometry> geometries;
    for (const Part& part : assembly.parts)
        geometries.emplace_back(part.mesh);
    return plan_system({assembly, is_thin, geometries, ControlBoxes(assembly)});
}

// A ring of four plates, and a fifth that nothing reaches, in the middle of the list.
Assembly ring_and_one(PropagationType type)
{
    Assembly assembly = frames::ring(ContactType::rigid).assembly;
    assembly.propagation.type = type;
    frames::add_plate(assembly, "alone", {0.0, 500.0, 0.0}, true);
    std::swap(assembly.parts[1], assembly.parts.back());
    const int last = static_cast<int>(assembly.parts.size()) - 1;
    const auto follow = [&](int& part) { part = part == 1 ? last : part == last ? 1 : part; };
    for (PartFeature& feature : assembly.features)
        follow(feature.part);
    for (Contact& contact : assembly.contacts)
        for (PartRegion* region : {&contact.a, &contact.b})
            follow(region->part);
    return assembly;
}

TEST(System, HasASheetForEveryPartThatIsAnsweredByItself)
{
    const System system = system_of(ring_and_one(PropagationType::local));
    ASSERT_EQ(system.sheets.size(), 5U);
    for (int part = 0; part < 5; ++part)
        EXPECT_EQ(system.sheets[static_cast<std::size_t>(system.sheet_of(part))].parts,
                  std::vector<int>{part});
    EXPECT_EQ(system.order.size(), 4U);
    EXPECT_GT(system.stages.size(), 1U);
}

TEST(System, HasOneSheetForAllThatAreAnsweredAtOnce)
{
    const Assembly assembly = ring_and_one(PropagationType::whole);
    const System system = system_of(assembly);
    ASSERT_EQ(system.sheets.size(), 2U);
    EXPECT_EQ(system.sheets[0].parts, (std::vector<int>{0, 2, 3, 4}));
    EXPECT_EQ(system.sheets[1].parts, std::vector<int>{1});
    EXPECT_FALSE(system.sheets[1].is_driven());
    EXPECT_EQ(system.order, std::vector<int>{0});
    EXPECT_EQ(system.stages, std::vector<std::vector<int>>{{0}});
    // A stack of rigid contacts is a body of the parts on both of its sides, and of no other.
    const Sheet& sheet = system.sheets[0];
    EXPECT_EQ(sheet.carriers.size(), system.welds.size());
    for (std::size_t k = 0; k < sheet.carriers.size(); ++k)
    {
        const RigidWeld& weld = system.welds[k];
        const int body = static_cast<int>(sheet.features.size() + k);
        for (int part = 0; part < 5; ++part)
        {
            const std::vector<int>& bodies = system.owners[static_cast<std::size_t>(part)].bodies;
            EXPECT_EQ(std::count(bodies.begin(), bodies.end(), body),
                      part == weld.source_part || part == weld.target_part ? 1 : 0);
        }
    }
}

class DrawnSystems : public testing::TestWithParam<unsigned>
{
};

// What some draws say contradicts itself: the first one from a seed on that does not.
std::pair<Assembly, System> drawn_from(unsigned seed)
{
    for (unsigned next = 1000 * seed;; ++next)
    {
        Assembly assembly = frames::DrawnAssembly(next).frame().assembly;
        for (Part& part : assembly.parts)
            part.mode = Mode::automatic;
        assembly.unheld = Unheld::along;
        assembly.propagation.type = PropagationType::whole;
        try
        {
            System system = system_of(assembly);
            return {std::move(assembly), std::move(system)};
        }
        catch (const InvalidInput&)
        {
            continue;
        }
    }
}

TEST_P(DrawnSystems, OwnEveryVertexOfEveryPartOnce)
{
    const auto [assembly, system] = drawn_from(GetParam());
    std::vector<int> owned(system.sheets.size(), 0);
    for (std::size_t part = 0; part < assembly.parts.size(); ++part)
    {
        const mesh::TriangleMesh& mesh = assembly.parts[part].mesh;
        const Owner& owner = system.owners[part];
        const Sheet& sheet = system.sheets[static_cast<std::size_t>(owner.sheet)];
        EXPECT_EQ(owner.count, mesh.vertex_count());
        EXPECT_EQ(sheet.mesh.points().middleRows(owner.first, owner.count), mesh.points());
        EXPECT_EQ(sheet.mesh.triangles().middleRows(owner.first_triangle, mesh.triangle_count()),
                  Triangles(mesh.triangles().array() + owner.first));
        for (const int vertex : {owner.first, owner.first + owner.count - 1})
            EXPECT_EQ(sheet.part_of(vertex), static_cast<int>(part));
        owned[static_cast<std::size_t>(owner.sheet)] += owner.count;
        for (std::size_t k = 0; k < owner.features.size(); ++k)
            EXPECT_EQ(
                owner.own(
                    sheet.surface.features[static_cast<std::size_t>(owner.bodies[k])].vertices),
                assembly.features[static_cast<std::size_t>(owner.features[k])].vertices);
    }
    for (std::size_t k = 0; k < owned.size(); ++k)
        EXPECT_EQ(owned[k], system.sheets[k].mesh.vertex_count());
}

INSTANTIATE_TEST_SUITE_P(Seeds, DrawnSystems, testing::Range(0U, 12U));

//! A plate with three holes, and the same cut at random into flush pieces, in any order, numbered
//! anew, each of them joined to the next; with a part that nothing reaches among them.
class Pieces
{
public:
    explicit Pieces(unsigned seed) : draw_(seed)
    {
        whole.energy = pieces.energy = draw_.one_of<surface::Energy>(
            {surface::Energy::neumann, surface::Energy::paper, surface::Energy::natural});
        pieces.propagation.type = PropagationType::whole;
        whole.parts.push_back({"plate", plate_.mesh, {}});
        cut();
        for (std::size_t hole = 0; hole < plate_.rims.size(); ++hole)
            add_hole(static_cast<int>(hole));
        whole.pairs = pieces.pairs = {{"pair", surface::FeatureLinkType::distance, 0, 2}};
        const PartRegion root{"root", 0, plate_.left}, tip{"tip", 0, plate_.right};
        whole.fixed = {root};
        pieces.fixed = {on_piece(root)};
        for (Assembly* assembly : {&whole, &pieces})
        {
            const PartRegion end = assembly == &whole ? tip : on_piece(tip);
            assembly->handles = {{end.name, end.part, end.vertices}};
        }
        pose.handles["tip"] = {draw_.within(15.0), draw_.within(0.3), {180.0, 30.0, 0.0}};
        pieces.primary = on_piece(draw_.happens(0.5) ? root : tip).part;
    }

    //! By piece and vertex: that of the plate.
    std::vector<VertexIds> places() const
    {
        std::vector<VertexIds> found;
        for (const Part& part : pieces.parts)
            found.emplace_back(static_cast<std::size_t>(part.mesh.vertex_count()), -1);
        for (std::size_t part = 0; part < found.size(); ++part)
            for (std::size_t vertex = 0; vertex < index_of_[part].size(); ++vertex)
                if (const int own = index_of_[part][vertex]; own >= 0)
                    found[part][static_cast<std::size_t>(own)] = static_cast<int>(vertex);
        return found;
    }

    Assembly whole, pieces;
    Pose pose;

private:
    void cut()
    {
        std::vector<double> cuts = {60.0, 120.0};
        if (draw_.happens(0.5))
            cuts.erase(cuts.begin() + draw_.whole(2));
        std::vector<int> order(cuts.size() + 2);  // the last one is no piece
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t k = order.size(); k > 1; --k)
            std::swap(order[k - 1],
                      order[static_cast<std::size_t>(draw_.whole(static_cast<int>(k)))]);
        for (const int k : order)
            if (k > static_cast<int>(cuts.size()))
                add_alone();
            else
                add_piece(
                    k == 0 ? -1.0 : cuts[static_cast<std::size_t>(k) - 1],
                    k == static_cast<int>(cuts.size()) ? 181.0 : cuts[static_cast<std::size_t>(k)]);
        for (const double at : cuts)
            join(at);
    }

    void add_alone()
    {
        index_of_.emplace_back();
        frames::add_plate(pieces, "alone", {0.0, 500.0, 0.0}, false);
    }

    void add_piece(double from, double to)
    {
        std::vector<int> triangles;
        for (int t = 0; t < plate_.mesh.triangle_count(); ++t)
        {
            double middle = 0.0;
            for (int k = 0; k < 3; ++k)
                middle += plate_.mesh.points()(plate_.mesh.triangles()(t, k), 0) / 3.0;
            if (middle > from && middle < to)
                triangles.push_back(t);
        }
        const mesh::Submesh piece = mesh::submesh(plate_.mesh, triangles);
        const shapes::Renumbered other =
            shapes::renumbered(piece.mesh, static_cast<unsigned>(draw_.whole(1000)));
        index_of_.push_back(piece.index_of);
        for (int& vertex : index_of_.back())
            if (vertex >= 0)
                vertex = other.new_id[static_cast<std::size_t>(vertex)];
        pieces.parts.push_back({"piece " + std::to_string(draw_.whole(10000)), other.mesh, {}});
    }

    // A region of the plate on the only piece, or the first one, that has all of it.
    PartRegion on_piece(PartRegion region, int after = -1) const
    {
        for (int part = after + 1; part < static_cast<int>(index_of_.size()); ++part)
        {
            VertexIds found;
            for (const int vertex : region.vertices)
                if (const VertexIds& index = index_of_[static_cast<std::size_t>(part)];
                    !index.empty() && index[static_cast<std::size_t>(vertex)] >= 0)
                    found.push_back(index[static_cast<std::size_t>(vertex)]);
            if (found.size() == region.vertices.size())
                return {region.name, part, found};
        }
        return {};
    }

    void join(double at)
    {
        const PartRegion edge{"edge", 0,
                              shapes::vertices_where(plate_.mesh, [=](const Vector3& p)
                                                     { return std::abs(p.x() - at) < 1e-6; })};
        Contact contact;
        contact.name = "seam " + std::to_string(pieces.contacts.size());
        contact.type = draw_.one_of<ContactType>({ContactType::tied, ContactType::control_mesh});
        contact.a = on_piece(edge);
        contact.b = on_piece(edge, contact.a.part);
        if (draw_.happens(0.5))
            std::swap(contact.a, contact.b);
        pieces.contacts.push_back(contact);
    }

    void add_hole(int k)
    {
        PartFeature hole;
        hole.name = "hole" + std::to_string(k);
        const PartRegion rim{hole.name, 0, plate_.rims[static_cast<std::size_t>(k)]};
        const PartRegion cut = on_piece(rim);
        hole.vertices = rim.vertices;
        whole.features.push_back(hole);
        hole.part = cut.part;
        hole.vertices = cut.vertices;
        pieces.features.push_back(hole);
    }

    shapes::Draw draw_;
    const shapes::PlateWithHoles plate_ = shapes::plate_with_holes({3, 16, 3, 60.0, 12.0});
    std::vector<VertexIds> index_of_;  // by part and vertex of the plate: that of the part, or -1
};

class FlushPieces : public testing::TestWithParam<unsigned>
{
};

TEST_P(FlushPieces, AreThePlateThatTheyWereCutFrom)
{
    const Pieces cut(GetParam());
    const DeformationSession whole(cut.whole), pieces(cut.pieces);
    for (const Exactness exactness : {Exactness::exact, Exactness::live})
    {
        const Deformed one = whole.deform(cut.pose, exactness);
        const Deformed all = pieces.deform(cut.pose, exactness);
        const double allowed = exactness == Exactness::exact ? 1e-7 : 2e-4;  // mm
        const std::vector<VertexIds> places = cut.places();
        for (std::size_t part = 0; part < places.size(); ++part)
            for (std::size_t k = 0; k < places[part].size(); ++k)
            {
                const auto row = static_cast<Eigen::Index>(k);
                const int vertex = places[part][k];
                const Eigen::RowVector3d expected =
                    vertex < 0 ? cut.pieces.parts[part].mesh.points().row(row)
                               : one.parts[0].positions.row(vertex);
                EXPECT_LT((all.parts[part].positions.row(row) - expected).norm(), allowed);
            }
        for (std::size_t k = 0; k < one.features.size(); ++k)
        {
            EXPECT_LT(
                (all.features[k].motion.rotation_log - one.features[k].motion.rotation_log).norm(),
                allowed / 100.0);
            EXPECT_LT(all.features[k].edge_error, 1e-9);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FlushPieces, testing::Range(0U, 16U));

}  // namespace
}  // namespace sheetmorph::assembly

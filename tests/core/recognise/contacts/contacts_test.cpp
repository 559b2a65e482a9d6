// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/contacts/contacts.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/recognise/features/features.h"
#include "shapes/plates.h"
#include "shapes/thick.h"
#include "shapes/variations.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sheetmorph::recognise
{

namespace
{

ContactPart part_of(const mesh::TriangleMesh& mesh, double thickness = 0.0)
{
    return {mesh, thickness, find_features(mesh)};
}

mesh::TriangleMesh shifted(const mesh::TriangleMesh& mesh, const Vector3& by)
{
    return shapes::mapped(mesh, [&](const Vector3& p) { return Vector3(p + by); });
}

ContactTolerances with_gap(double gap)
{
    ContactTolerances tolerances;
    tolerances.gap = gap;
    return tolerances;
}

TEST(Contacts, OverlappingSheetsTouchWhereTheyOverlap)
{
    const auto sheet = shapes::grid(20, 10, 100.0, 50.0);
    const auto found =
        find_contacts({part_of(sheet), part_of(shifted(sheet, {70, 0, 1.2}))}, {}, with_gap(1.5));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, ContactKind::face);
    EXPECT_EQ(found[0].a.size(), 7u * 11u);
    EXPECT_EQ(found[0].b.size(), 7u * 11u);
    EXPECT_NEAR(found[0].distance, 1.2, 1e-12);
    EXPECT_NEAR(found[0].size, Vector3(30.0, 50.0, 1.2).norm(), 1e-12);
    EXPECT_LT((found[0].center - Vector3(85.0, 25.0, 0.6)).norm(), 1e-12);
}

TEST(Contacts, KnownThicknessAddsToTheGap)
{
    const auto sheet = shapes::grid(20, 10, 100.0, 50.0);
    const auto above = shifted(sheet, {70, 0, 3.0});
    EXPECT_TRUE(find_contacts({part_of(sheet), part_of(above)}, {}, with_gap(0.5)).empty());
    EXPECT_EQ(find_contacts({part_of(sheet, 2.0), part_of(above, 3.5)}, {}, with_gap(0.5)).size(),
              1u);
}

TEST(Contacts, TwoPlacesOfOnePairAreTwoContacts)
{
    const auto base = shapes::grid(40, 10, 200.0, 50.0);
    const auto bridge =
        shapes::mapped(shapes::grid(40, 10, 200.0, 50.0), [](Vector3 p)
                       { return Vector3(p.x(), p.y(), p.x() < 41 || p.x() > 159 ? 1.0 : 20.0); });
    ContactTolerances tolerances = with_gap(1.2);
    EXPECT_EQ(find_contacts({part_of(base), part_of(bridge)}, {}, tolerances).size(), 2u);
    tolerances.joins_pairs = true;
    EXPECT_EQ(find_contacts({part_of(base), part_of(bridge)}, {}, tolerances).size(), 1u);
}

TEST(Contacts, TheNumbersOfVerticesDoNotDecideWhatOneContactIs)
{
    const auto base = shapes::grid(40, 10, 200.0, 50.0);
    const auto bridge =
        shapes::mapped(shapes::grid(20, 5, 200.0, 50.0), [](Vector3 p)
                       { return Vector3(p.x(), p.y(), p.x() < 41 || p.x() > 139 ? 1.0 : 20.0); });
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        const shapes::Renumbered one = shapes::renumbered(base, seed);
        const shapes::Renumbered other = shapes::renumbered(bridge, seed + 100);
        const auto found =
            find_contacts({part_of(one.mesh), part_of(other.mesh)}, {}, with_gap(1.2));
        ASSERT_EQ(found.size(), 2u) << seed;
        for (const FoundContact& contact : found)
            EXPECT_LT(contact.size, 100.0) << seed;
    }
}

TEST(Contacts, CoaxialHolesAreABolt)
{
    const auto plate = shapes::plate_with_holes().mesh;
    const auto found =
        find_contacts({part_of(plate), part_of(shifted(plate, {60, 0, 1.0}))}, {}, with_gap(1.2));
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].kind, ContactKind::face);
    EXPECT_EQ(found[1].kind, ContactKind::bolt);
    EXPECT_STREQ(type_of(found[1]), "rigid");
    EXPECT_EQ(found[1].a.size(), 64u);
    EXPECT_NEAR((found[1].center - Vector3(90, 30, 0.5)).norm(), 0.0, 1e-9);
}

TEST(Contacts, SolidsTouchWithTheirOutsidesOnly)
{
    const auto plate = shapes::thickened(shapes::grid(10, 10, 50.0, 50.0), 0.5);
    const auto on_top = shifted(plate, {20, 0, 0.5});
    const auto found = find_contacts({part_of(plate), part_of(on_top)}, {}, with_gap(0.6));
    ASSERT_EQ(found.size(), 1u);
    for (const int vertex : found[0].a)
        EXPECT_LT(vertex, 121);  // the upper skin of the lower plate
}

TEST(Contacts, AFreeEdgeOnASurfaceIsAContact)
{
    const auto base = shapes::grid(20, 20, 100.0, 100.0);
    const auto wall = shapes::mapped(shapes::grid(20, 5, 100.0, 25.0),
                                     [](const Vector3& p) { return Vector3(p.x(), 52.0, p.y()); });
    const auto found = find_contacts({part_of(base), part_of(wall)}, {}, with_gap(0.5));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, ContactKind::edge);
    EXPECT_EQ(found[0].b.size(), 21u);
    EXPECT_GE(found[0].a.size(), 3u);
}

TEST(Contacts, ElementsBetweenPartsAreWelds)
{
    const auto sheet = shapes::grid(20, 10, 100.0, 50.0);
    const std::vector<ContactPart> parts = {part_of(sheet), part_of(shifted(sheet, {70, 0, 6.0}))};
    const std::vector<Connection> rivets = {{0, 14, 1, 0}, {0, 35, 1, 21}, {0, 56, 1, 42}};
    const auto found = find_contacts(parts, rivets, with_gap(0.5));
    // A rivet each: as one rigid body they would keep the seam from bending.
    ASSERT_EQ(found.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_EQ(found[k].kind, ContactKind::weld);
        EXPECT_STREQ(type_of(found[k]), "rigid");
        EXPECT_EQ(found[k].connections, 1);
        EXPECT_EQ(found[k].a, (VertexIds{rivets[k].vertex_a}));
    }
    EXPECT_THROW(find_contacts(parts, {{0, 999, 1, 0}}), InvalidInput);
}

TEST(Contacts, ConnectionsOfOneJointAreOneWeldAndThoseOfSeveralASeam)
{
    const auto sheet = shapes::grid(20, 10, 100.0, 50.0);
    const std::vector<ContactPart> parts = {part_of(sheet), part_of(shifted(sheet, {70, 0, 6.0}))};
    const std::vector<Connection> spider = {{0, 14, 1, 0, 7}, {0, 35, 1, 21, 7}, {1, 42, 0, 56, 8}};
    const auto found = find_contacts(parts, spider, with_gap(0.5));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].a, (VertexIds{14, 35}));
    EXPECT_STREQ(type_of(found[0]), "rigid");
    EXPECT_EQ(found[1].a, (VertexIds{56}));
    EXPECT_EQ(found[1].b, (VertexIds{42}));
    // Joints that share a vertex cannot be rigid each: they are one seam.
    const auto seam = find_contacts(parts, {{0, 14, 1, 0, 7}, {0, 14, 1, 21, 8}}, with_gap(0.5));
    ASSERT_EQ(seam.size(), 1u);
    EXPECT_STREQ(type_of(seam[0]), "tied");
}

TEST(Contacts, WeldsInAPatchMakeItASeamAndRigidBodiesStandBesideIt)
{
    const auto sheet = shapes::grid(20, 10, 100.0, 50.0);
    const std::vector<ContactPart> parts = {part_of(sheet), part_of(shifted(sheet, {0, 0, 1.0}))};
    const auto welded = find_contacts(parts, {{0, 14, 1, 14}, {0, 35, 1, 35}}, with_gap(1.2));
    ASSERT_EQ(welded.size(), 1u);
    EXPECT_EQ(welded[0].kind, ContactKind::weld);
    EXPECT_EQ(welded[0].connections, 2);
    EXPECT_STREQ(type_of(welded[0]), "tied");
    const auto bolted = find_contacts(parts, {{0, 14, 1, 14, 3, true}}, with_gap(1.2));
    ASSERT_EQ(bolted.size(), 2u);
    EXPECT_EQ(bolted[0].kind, ContactKind::face);
    EXPECT_EQ(std::count(bolted[0].a.begin(), bolted[0].a.end(), 14), 0);
    EXPECT_EQ(bolted[1].a, (VertexIds{14}));
    EXPECT_STREQ(type_of(bolted[1]), "rigid");
}

TEST(Contacts, TheGapIsProposedFromTheAssembly)
{
    const auto sheet = shapes::grid(20, 10, 100.0, 50.0);
    for (const double scale : {1.0, 1e-3})
    {
        std::vector<ContactPart> parts;
        for (const double height : {0.0, 1.2, 40.0})
            parts.push_back(
                part_of(shapes::mapped(shifted(sheet, {height, 0, height}),
                                       [=](const Vector3& p) { return Vector3(scale * p); })));
        const double gap = proposed_gap(parts) / scale;
        EXPECT_GT(gap, 1.2);
        EXPECT_LT(gap, 3.0);
        EXPECT_EQ(find_contacts(parts).size(), 1u);
    }
}

TEST(Contacts, LargePartsThatDoNotTouchAreNotProposed)
{
    const auto sheet = shapes::grid(60, 6, 3000.0, 300.0);
    std::vector<ContactPart> parts = {part_of(sheet), part_of(shifted(sheet, {0.0, 0.0, 30.0}))};
    EXPECT_LT(proposed_gap(parts), 12.5);
    EXPECT_TRUE(find_contacts(parts).empty());
    // What touches beside them is found by its own gap.
    parts.push_back(part_of(shifted(sheet, {1500.0, 0.0, -1.5})));
    EXPECT_LT(proposed_gap(parts), 6.0);  // a thousandth of 4.5 m, and a fifth more
    EXPECT_EQ(find_contacts(parts).size(), 1u);
}

TEST(Contacts, AThousandPartsAreNoTrouble)
{
    const auto sheet = shapes::grid(4, 2, 20.0, 10.0);
    std::vector<ContactPart> parts;
    for (int i = 0; i < 1000; ++i)
        parts.push_back(
            {shifted(sheet, {15.0 * (i % 40), 30.0 * (i / 40), 0.5 * (i % 2)}), 0.0, {}});
    EXPECT_EQ(find_contacts(parts, {}, with_gap(0.6)).size(), 25u * 39u);
}

}  // namespace

}  // namespace sheetmorph::recognise

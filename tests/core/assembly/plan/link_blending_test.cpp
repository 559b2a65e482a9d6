// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/link_blending.h"

#include "sheetmorph/assembly/session/deformation_session.h"
#include "sheetmorph/mesh/quality/quality.h"
#include "assembly/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace sheetmorph::assembly
{

using namespace mesh;
namespace
{

// A strip of 100 x 10 mm, its vertices 1 mm apart.
TriangleMesh strip()
{
    return shapes::grid(100, 10, 100.0, 10.0);
}

Part part(const std::string& name, const TriangleMesh& mesh)
{
    Part found;
    found.name = name;
    found.mesh = mesh;
    return found;
}

PlannedLink link_between(const TriangleMesh& mesh, double from, double to)
{
    PlannedLink link;
    link.contact = 0;
    link.targets = {{0, shapes::vertices_where(
                            mesh, [=](const Vector3& p) { return p.x() > from && p.x() < to; })}};
    return link;
}

TEST(LinkBlending, WeightsFallFromTheOwnRegionOverATenthOfTheSmaller)
{
    Assembly assembly;
    assembly.parts = {part("strip", strip())};
    const Points& points = assembly.parts[0].mesh.points();
    std::vector<PlannedLink> links = {link_between(strip(), -0.5, 40.5),
                                      link_between(strip(), 41.5, 90.5)};
    blend_neighbours(assembly, links);
    const double reach = 0.1 * std::hypot(40.0, 10.0);
    const LinkTarget& target = links[0].targets[0];
    ASSERT_EQ(target.weights.size(), target.vertices.size());
    int beside = 0;
    for (std::size_t k = 0; k < target.vertices.size(); ++k)
    {
        const double away = std::max(0.0, points(target.vertices[k], 0) - 40.0);
        EXPECT_NEAR(target.weights[k], 1.0 - away / reach, 1e-12);
        beside += away > 0.0;
    }
    EXPECT_EQ(beside, 3 * 11);  // 42, 43 and 44 mm
}

TEST(LinkBlending, OtherTypesAndOtherPartsAreLeftAlone)
{
    Assembly assembly;
    assembly.parts = {part("strip", strip()), part("other", strip())};
    std::vector<PlannedLink> links = {link_between(strip(), -0.5, 40.5),
                                      link_between(strip(), 41.5, 90.5),
                                      link_between(strip(), 41.5, 90.5)};
    links[1].type = ContactType::tied;
    links[2].targets[0].part = 1;
    const std::size_t before = links[0].targets[0].vertices.size();
    blend_neighbours(assembly, links);
    EXPECT_EQ(links[0].targets[0].vertices.size(), before);
}

// One half of the lead is pushed 1.5 mm over the other: what is tied to either is squeezed between
// two vertices that are 1 mm apart.
TEST(LinkBlending, ASheetBetweenTwoContactsThatDisagreeDoesNotFold)
{
    Assembly assembly;
    const auto above = [](const Vector3& p) { return Vector3(p + Vector3(0.0, 0.0, 1.0)); };
    assembly.parts = {part("lead", strip()), part("sheet", shapes::mapped(strip(), above))};
    const auto low = [](const Vector3& p) { return p.x() < 40.5; };
    const auto high = [](const Vector3& p) { return p.x() > 40.5; };
    assembly.fixed = {frames::side("root", assembly, 0, low)};
    assembly.handles = {{"tip", 0, frames::side("tip", assembly, 0, high).vertices}};
    const auto tie = [&](const auto& where)
    {
        Contact contact;
        contact.name = "tie " + std::to_string(assembly.contacts.size());
        contact.type = ContactType::tied;
        contact.a = frames::side("a", assembly, 0, where);
        contact.b = frames::side("b", assembly, 1, where);
        assembly.contacts.push_back(contact);
    };
    tie(low);
    tie(high);
    Pose pose;
    pose.handles["tip"].translation = Vector3(-1.5, 0.0, 0.0);
    const Points positions = DeformationSession(assembly).deform(pose).parts[1].positions;
    EXPECT_TRUE(compare_quality(assembly.parts[1].mesh, positions).flipped.empty());
    EXPECT_GT(compare_quality(assembly.parts[1].mesh, positions).smallest_stretch, 0.3);
}

}  // namespace
}  // namespace sheetmorph::assembly

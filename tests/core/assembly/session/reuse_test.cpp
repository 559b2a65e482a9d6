// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/reuse.h"

#include "shapes.h"

#include <functional>
#include <gtest/gtest.h>

namespace sheetmorph::assembly
{

using namespace surface;
namespace
{

// Constraints of a strip with something of every kind.
SurfaceConstraints with_everything(const mesh::TriangleMesh& mesh)
{
    SurfaceConstraints one;
    one.fixed = {
        {"root", shapes::vertices_where(mesh, [](const Vector3& p) { return p.x() < 1; })}};
    one.handles = {
        {"tip", shapes::vertices_where(mesh, [](const Vector3& p) { return p.x() > 99; })}};
    one.features = {{"hole", {45, 46, 47}}, {"pin", {66, 67, 68}}, {"slot", {88, 89, 90}}};
    one.points = {{"probe", 20, {0.2, 0.3, 0.5}, false}};
    one.propagated = {{"weld", {100}, "contact"}};
    one.groups = {{0, 1}};
    one.links = {{"bar", FeatureLinkType::distance, 2, -1, {1.0, 2.0, 3.0}, {0.0, 0.0, 1.0}}};
    one.stitches = {{"stitch", {110, 111}, "contact"}};
    one.ties = {{120, mesh::Anchor::at_vertex(30)}};
    return one;
}

using Edit = std::function<void(SurfaceConstraints&)>;

// What was prepared serves again only for the same constraints: any edit starts anew.
void expect_new_after(const std::vector<Edit>& edits)
{
    const mesh::TriangleMesh mesh = shapes::grid(20, 5, 100.0, 25.0);
    const SurfaceConstraints own = with_everything(mesh);
    const SurfaceDeformer deformer(mesh, own);
    EXPECT_TRUE(is_deformer_of(deformer, mesh, own));
    EXPECT_FALSE(is_deformer_of(deformer, shapes::grid(20, 5, 100.0, 26.0), own));
    for (std::size_t k = 0; k < edits.size(); ++k)
    {
        SurfaceConstraints edited = own;
        edits[k](edited);
        EXPECT_FALSE(is_deformer_of(deformer, mesh, edited)) << "edit " << k;
    }
}

TEST(Reuse, AnotherEnergyOrRegionStartsAnew)
{
    expect_new_after({
        [](auto& c) { c.energy = Energy::natural; },
        [](auto& c) { c.laplacian = Laplacian::intrinsic; },
        [](auto& c) { c.is_refined = true; },
        [](auto& c) { c.thickness = 2.0; },
        [](auto& c) { c.poisson = 0.2; },
        [](auto& c) { c.fixed[0].vertices.pop_back(); },
        [](auto& c) { c.fixed[0].name = "foot"; },
        [](auto& c) { c.fixed.clear(); },
        [](auto& c) { c.handles[0].is_rotation_free = true; },
        [](auto& c) { c.handles[0].vertices.pop_back(); },
        [](auto& c) { c.propagated[0].vertices = {101}; },
        [](auto& c) {
            c.stitches[0].vertices = {110, 112};
        },
        [](auto& c) { c.ties[0].place = mesh::Anchor::at_vertex(31); },
        [](auto& c) { c.ties[0].vertex = 121; },
    });
}

TEST(Reuse, AnotherFeaturePointOrLinkStartsAnew)
{
    expect_new_after({
        [](auto& c) { c.features[0].vertices.pop_back(); },
        [](auto& c) { c.features[0].rotation = FeatureRotation::interpolated; },
        [](auto& c) { c.features[0].is_resizable = true; },
        [](auto& c) { c.features[0].motion.type = FeatureMotion::Type::line; },
        [](auto& c) { c.features[0].motion.point.x() = 1.0; },
        [](auto& c) { c.features[0].motion.direction = Vector3::UnitX(); },
        [](auto& c) { c.points[0].triangle = 21; },
        [](auto& c) {
            c.points[0].barycentric = {0.3, 0.2, 0.5};
        },
        [](auto& c) { c.points[0].is_turned = true; },
        [](auto& c) { c.points[0].is_rotation_free = true; },
        [](auto& c) {
            c.groups = {{0, 2}};
        },
        [](auto& c) { c.links[0].type = FeatureLinkType::coaxial; },
        [](auto& c) { c.links[0].follower = 1; },
        [](auto& c) { c.links[0].leader = 0; },
        [](auto& c) { c.links[0].centre.x() = 2.0; },
        [](auto& c) { c.links[0].direction = Vector3::UnitX(); },
    });
}

}  // namespace
}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
// Finite element decks have nodes of no triangle: they change nothing, wherever they stand.
#include "shapes/unused_nodes.h"
#include "sheetmorph/surface/live/drawn_motions.h"
#include "sheetmorph/surface/live/response.h"
#include "surface/all_cases.h"
#include "surface/free_strip.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;

Case renamed(Case one, const shapes::Renumbered& other)
{
    const auto rename = [&](auto& regions)
    {
        for (auto& region : regions)
            for (int& id : region.vertices)
                id = other.new_id[static_cast<std::size_t>(id)];
    };
    rename(one.constraints.fixed);
    rename(one.constraints.handles);
    rename(one.constraints.features);
    rename(one.constraints.propagated);
    one.mesh = other.mesh;
    return one;
}

double worst_difference(const Case& one, const Points& expected, const shapes::Renumbered& other,
                        const Points& found)
{
    return (Points(found(other.new_id, Eigen::indexing::all)) - expected)
               .rowwise()
               .norm()
               .maxCoeff()
           / one.mesh.size();
}

class UnusedNodes : public testing::TestWithParam<Case>
{
};

TEST_P(UnusedNodes, ChangeNoShapeWhereverTheyStand)
{
    const Case& one = GetParam();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    for (const std::vector<int>& places : shapes::unused_places(one.mesh))
    {
        const shapes::Renumbered other = shapes::with_unused_nodes(one.mesh, places);
        const Case with = renamed(one, other);
        const SurfaceDeformer same(with.mesh, with.constraints);
        for (const Exactness exactness : {Exactness::live, Exactness::exact})
        {
            const Points expected = deformer.deform(one.targets, exactness).positions;
            const Points found = same.deform(with.targets, exactness).positions;
            EXPECT_TRUE(found.allFinite());
            // A refined shape is told to what its last round may change.
            const bool is_told_to_rounding =
                exactness == Exactness::exact && !one.constraints.is_refined;
            EXPECT_LT(worst_difference(one, expected, other, found),
                      is_told_to_rounding ? 1e-9 : 1e-6);
        }
    }
}

// The shape that the response gives without substitution, nothing where there is none.
std::vector<Points> frames_of(const Case& one)
{
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    std::vector<Points> found;
    Deformation shape;
    if (deformer.can_respond())
    {
        const auto response =
            deformer.response(own_poses(one.mesh, one.constraints, one.targets, {0}), {});
        if (const auto frame = response->frame(one.targets))
        {
            response->place(*frame, shape);
            found.push_back(shape.positions);
        }
    }
    return found;
}

TEST_P(UnusedNodes, ChangeNoFrameWithoutSubstitution)
{
    const Case& one = GetParam();
    const std::vector<Points> expected = frames_of(one);
    for (const std::vector<int>& places : shapes::unused_places(one.mesh))
    {
        const shapes::Renumbered other = shapes::with_unused_nodes(one.mesh, places);
        const std::vector<Points> found = frames_of(renamed(one, other));
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k)
        {
            EXPECT_TRUE(found[k].allFinite());
            EXPECT_LT(worst_difference(one, expected[k], other, found[k]), 1e-6);
        }
    }
}

// Features of every kind of rotation, motion, group and size, refined too.
std::vector<Case> all_kinds()
{
    std::vector<Case> cases;
    for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
        for (const bool is_refined : {false, true})
        {
            cases.push_back(cases::strip_with_holes(true));
            cases.back().constraints.energy = energy;
            cases.back().constraints.is_refined = is_refined;
            cases.back().name = "free" + std::to_string(cases.size());
        }
    Case sized = cases::strip_with_holes();
    for (FormFeature& feature : sized.constraints.features)
        feature.is_resizable = true;
    sized.targets.sizes = {32.0, 60.0, std::nullopt};
    sized.name = "sized";
    cases.push_back(sized);
    Case grouped = cases::strip_with_holes();
    grouped.constraints.groups = {{0, 1}};
    grouped.constraints.features[2].motion.type = FeatureMotion::Type::plane;
    grouped.constraints.laplacian = Laplacian::intrinsic;
    grouped.name = "grouped";
    cases.push_back(grouped);
    for (Case one : cases::all_with_every_energy())
        if (one.name.find("flat_plate") == 0)
            cases.push_back(one);
    return cases;
}

INSTANTIATE_TEST_SUITE_P(All, UnusedNodes, testing::ValuesIn(all_kinds()),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
// Constraints edited one after the other give what a fresh start with the same ones gives.
#include "surface/all_cases.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;

class EditedConstraints : public testing::TestWithParam<Case>
{
};

// Some vertices in a row that no constraint names.
VertexIds unnamed_vertices(const Case& one, std::size_t count)
{
    std::vector<char> is_named(static_cast<std::size_t>(one.mesh.vertex_count()), 0);
    const auto name = [&](const VertexIds& vertices)
    {
        for (const int vertex : vertices)
            is_named[static_cast<std::size_t>(vertex)] = 1;
    };
    for (const auto* regions : {&one.constraints.fixed, &one.constraints.handles})
        for (const KnownRegion& region : *regions)
            name(region.vertices);
    for (const FormFeature& feature : one.constraints.features)
        name(feature.vertices);
    VertexIds found;
    for (int vertex = one.mesh.vertex_count() / 3; vertex < one.mesh.vertex_count(); ++vertex)
        if (found.size() < count && is_named[static_cast<std::size_t>(vertex)] == 0)
            found.push_back(vertex);
    return found;
}

void add_feature(Case& one, FeatureRotation rotation)
{
    one.constraints.features.push_back({"new", unnamed_vertices(one, 4), rotation, "feature"});
    one.targets.feature_logs.emplace_back(Vector3::Zero());
}

void remove_feature(Case& one)
{
    one.constraints.features.erase(one.constraints.features.begin());
    one.targets.feature_logs.erase(one.targets.feature_logs.begin());
}

void add_handle(Case& one)
{
    one.constraints.handles.push_back({"second", unnamed_vertices(one, 3), "handle"});
    one.targets.handles.push_back(
        cases::motion({1.0, 2.0, 3.0}, {0.1, 0.2, 1.0}, 10.0, Vector3::Zero()));
}

struct Edit
{
    std::string name;
    std::function<void(Case&)> apply;
};

std::vector<Edit> edits()
{
    return {{"a fixed region more",
             [](Case& one) {
                 one.constraints.fixed.push_back({"new", unnamed_vertices(one, 5), "region"});
             }},
            {"a feature more", [](Case& one) { add_feature(one, FeatureRotation::interpolated); }},
            {"a free feature more", [](Case& one) { add_feature(one, FeatureRotation::free); }},
            {"a handle more", add_handle},
            {"a feature less", remove_feature},
            {"a fixed region less", [](Case& one) { one.constraints.fixed.pop_back(); }},
            {"a handle less",
             [](Case& one)
             {
                 one.constraints.handles.pop_back();
                 one.targets.handles.pop_back();
             }},
            {"a feature that turns freely now",
             [](Case& one) { one.constraints.features.front().rotation = FeatureRotation::free; }},
            {"a wider handle", [](Case& one)
             { one.constraints.handles.front().vertices.push_back(unnamed_vertices(one, 1)[0]); }}};
}

// Every state is made from the one before it, and compared with a fresh start.
TEST_P(EditedConstraints, GiveTheSameShapeAsAFreshStart)
{
    Case one = GetParam();
    if (one.name.find("jittered") == 0)
        add_feature(one, FeatureRotation::prescribed);
    auto last = std::make_unique<SurfaceDeformer>(one.mesh, one.constraints);
    for (const Edit& edit : edits())
    {
        edit.apply(one);
        const SurfaceDeformer fresh(one.mesh, one.constraints);
        auto edited =
            std::make_unique<SurfaceDeformer>(one.mesh, one.constraints, Progress(), last.get());
        const Deformation expected = fresh.deform(one.targets);
        const Deformation found = edited->deform(one.targets);
        EXPECT_LT((found.positions - expected.positions).cwiseAbs().maxCoeff(),
                  1e-9 * one.mesh.size())
            << one.name << ": " << edit.name;
        EXPECT_LT((found.rotation_logs - expected.rotation_logs).cwiseAbs().maxCoeff(), 1e-7)
            << one.name << ": " << edit.name;
        last = std::move(edited);
    }
}

TEST(EditedConstraints, AnotherMeshStartsAnew)
{
    const Case flat = cases::flat_plate();
    const Case bent = cases::bent_plate();
    const SurfaceDeformer before(flat.mesh, flat.constraints);
    const SurfaceDeformer after(bent.mesh, bent.constraints, Progress(), &before);
    EXPECT_EQ(after.deform(bent.targets).positions,
              SurfaceDeformer(bent.mesh, bent.constraints).deform(bent.targets).positions);
}

INSTANTIATE_TEST_SUITE_P(Cases, EditedConstraints,
                         testing::ValuesIn(cases::all_with_every_energy()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sheetmorph::surface

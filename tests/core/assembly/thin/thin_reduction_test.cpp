// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_reduction.h"

#include "shapes/thin.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace sheetmorph::assembly
{
namespace
{

// A plate of 2 mm as a thin solid, and vertices of its skins by the place in the sheet.
struct Plate
{
    mesh::TriangleMesh sheet = shapes::grid(20, 10, 100.0, 50.0);
    Assembly assembly;
    ThinParts thin;
    int main = 0, opposite = 0;  // the first vertex of each skin

    Plate()
    {
        Part part;
        part.name = "plate";
        part.mesh = shapes::two_skinned(sheet, 2.0);
        part.thin = Thin::yes;
        assembly.parts = {part};
        thin = find_thin_parts(assembly, nullptr, {});
        (thin[0]->skin().index_of[0] >= 0 ? opposite : main) = sheet.vertex_count();
    }

    VertexIds where(int first, double from, double to) const
    {
        VertexIds found = shapes::vertices_where(
            sheet, [=](const Vector3& p) { return p.x() > from - 1e-6 && p.x() < to + 1e-6; });
        for (int& vertex : found)
            vertex += first;
        return found;
    }

    Assembly reduced() const { return reduced_to_skins(assembly, thin); }

    // Places along x of vertices of the skin, mm.
    std::pair<double, double> extent(const VertexIds& of_skin) const
    {
        const auto x = thin[0]->skin().mesh.points()(of_skin, Eigen::indexing::all).col(0).eval();
        return {std::round(x.minCoeff()), std::round(x.maxCoeff())};
    }
};

bool share_vertices(const VertexIds& one, const VertexIds& other)
{
    return std::any_of(one.begin(), one.end(),
                       [&](int vertex)
                       { return std::find(other.begin(), other.end(), vertex) != other.end(); });
}

TEST(ThinReduction, AVertexBelowTwoRegionsStaysWithTheOneWhoseOwnItIs)
{
    Plate plate;
    plate.assembly.fixed = {{"root", 0, plate.where(plate.main, 0.0, 50.0)}};
    plate.assembly.handles = {{"tip", 0, plate.where(plate.opposite, 30.0, 70.0)}};
    const Assembly reduced = plate.reduced();
    EXPECT_EQ(plate.extent(reduced.fixed[0].vertices), std::pair(0.0, 50.0));
    EXPECT_EQ(plate.extent(reduced.handles[0].vertices), std::pair(55.0, 70.0));
    EXPECT_FALSE(share_vertices(reduced.fixed[0].vertices, reduced.handles[0].vertices));
}

TEST(ThinReduction, AVertexBelowTwoRegionsOfTheOppositeSkinStaysWithTheFirst)
{
    Plate plate;
    plate.assembly.fixed = {{"root", 0, plate.where(plate.opposite, 0.0, 50.0)}};
    plate.assembly.handles = {{"tip", 0, plate.where(plate.opposite, 55.0, 70.0)}};
    plate.assembly.features = {{"patch",
                                0,
                                plate.where(plate.main, 80.0, 90.0),
                                surface::FeatureRotation::free,
                                {},
                                {},
                                false}};
    const Assembly reduced = plate.reduced();
    EXPECT_EQ(plate.extent(reduced.fixed[0].vertices), std::pair(0.0, 50.0));
    EXPECT_EQ(plate.extent(reduced.handles[0].vertices), std::pair(55.0, 70.0));
    EXPECT_EQ(plate.extent(reduced.features[0].vertices), std::pair(80.0, 90.0));
}

// A handle on the opposite skin under which everything is fixed, and a rigid contact of its corner.
TEST(ThinReduction, WhatARigidContactTouchesOnThePartItTouchesOnTheSkin)
{
    Plate plate;
    plate.assembly.parts.push_back({"other", shapes::grid(2, 2, 10.0, 10.0), {}, Mode::automatic});
    plate.thin.emplace_back();
    plate.assembly.fixed = {{"root", 0, plate.where(plate.main, 0.0, 50.0)}};
    plate.assembly.handles = {{"tip", 0, plate.where(plate.opposite, 30.0, 70.0)}};
    const VertexIds corner = {plate.where(plate.opposite, 30.0, 30.0).front()};
    for (const ContactType type : {ContactType::rigid, ContactType::tied})
    {
        plate.assembly.contacts = {{"bolt", type, {"a", 0, corner}, {"b", 1, {0}}}};
        const Assembly reduced = plate.reduced();
        EXPECT_EQ(reduced.contacts[0].b.vertices, VertexIds{0});
        EXPECT_EQ(share_vertices(reduced.handles[0].vertices, reduced.contacts[0].a.vertices),
                  type == ContactType::rigid);
    }
}

TEST(ThinReduction, PointsKeepTheirPlaceInTheSheetAndVerticesTheirNumbers)
{
    Plate plate;
    Part& part = plate.assembly.parts[0];
    for (int i = 0; i < part.mesh.vertex_count(); ++i)
        part.ids.push_back(1000 + 3 * i);
    const Triangles& triangles = part.mesh.triangles();
    const auto place = [](const mesh::TriangleMesh& mesh, const surface::PointConstraint& point)
    {
        Vector3 sum = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            sum += point.barycentric(k)
                   * mesh.points().row(mesh.triangles()(point.triangle, k)).transpose();
        return sum;
    };
    for (int t = 0; t < triangles.rows(); t += 37)
    {
        if (plate.thin[0]->solid().facets[static_cast<std::size_t>(t)]
            == recognise::SolidSide::wall)
            continue;
        plate.assembly.points = {{"probe", 0, {"probe", t, {0.2, 0.3, 0.5}, false, false}}};
        const Assembly reduced = plate.reduced();
        const Vector3 before = place(part.mesh, plate.assembly.points[0].constraint);
        const Vector3 after = place(reduced.parts[0].mesh, reduced.points[0].constraint);
        EXPECT_LT((after - before).head<2>().norm(), 1e-9) << t;
    }
    const Assembly reduced = plate.reduced();
    const VertexIds& vertices = plate.thin[0]->skin().vertices;
    ASSERT_EQ(reduced.parts[0].ids.size(), vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k)
        EXPECT_EQ(reduced.parts[0].ids[k], 1000 + 3 * vertices[k]);
    EXPECT_NEAR(reduced.parts[0].sheet_thickness, 2.0, 1e-9);
}

}  // namespace
}  // namespace sheetmorph::assembly

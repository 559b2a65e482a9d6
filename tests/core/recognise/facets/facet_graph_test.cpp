// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/facets/facet_graph.h"

#include "shapes/plates.h"
#include "shapes/solids.h"
#include "shapes/variations.h"

#include <gtest/gtest.h>

namespace sheetmorph::recognise
{

using namespace mesh;

namespace
{

TEST(FacetGraph, NormalsOfAMeasuredBoxAreThoseOfItsSides)
{
    const TriangleMesh box = shapes::box(12, Vector3(60.0, 60.0, 60.0));
    const FacetGraph drawn(box, 1e-7);
    const FacetGraph measured(shapes::scattered(box, 0.25, 1), 1e-7);
    double worst = 0.0;
    for (int t = 0; t < box.triangle_count(); ++t)
        worst = std::max(worst, std::acos(std::min(1.0, drawn.normal(t).dot(measured.normal(t)))));
    EXPECT_LT(worst, 0.15);
    for (int t = 0; t < box.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(measured.bend(t, k), drawn.bend(t, k), 0.25);
}

TEST(FacetGraph, TrianglesMayBeOrientedAnyHow)
{
    const TriangleMesh plate = shapes::scattered(shapes::grid(20, 20, 100.0, 100.0), 0.2, 3);
    Triangles turned = plate.triangles();
    for (Eigen::Index t = 0; t < turned.rows(); t += 3)
        std::swap(turned(t, 0), turned(t, 1));
    const FacetGraph one(plate, 1e-7);
    const FacetGraph other(TriangleMesh(plate.points(), turned), 1e-7);
    EXPECT_NEAR(one.scatter(), other.scatter(), 1e-9);
    for (int t = 0; t < plate.triangle_count(); ++t)
        EXPECT_NEAR(std::abs(one.normal(t).dot(other.normal(t))), 1.0, 1e-9);
}

// A box that is turned inside out, and a sheet beside it.
TriangleMesh box_and_sheet()
{
    const TriangleMesh box = shapes::box(2, Vector3(10.0, 10.0, 10.0));
    const TriangleMesh sheet = shapes::grid(3, 3, 10.0, 10.0);
    Points points(box.vertex_count() + sheet.vertex_count(), 3);
    points << box.points(), (sheet.points().rowwise() + Eigen::RowVector3d(50.0, 0.0, 0.0));
    Triangles triangles(box.triangle_count() + sheet.triangle_count(), 3);
    triangles << box.triangles().rowwise().reverse(),
        (sheet.triangles().array() + box.vertex_count()).matrix();
    return {std::move(points), std::move(triangles)};
}

TEST(FacetGraph, KnowsWhichComponentsAreClosedAndWhereTheirOutsideIs)
{
    const TriangleMesh mesh = box_and_sheet();
    const FacetGraph graph = FacetGraph::of_solids(mesh);
    ASSERT_EQ(graph.component_count(), 2);
    EXPECT_TRUE(graph.is_closed(0));
    EXPECT_FALSE(graph.is_closed(1));
    const int sheet = mesh.triangle_count() - 1;
    ASSERT_EQ(graph.component(sheet), 1);
    Vector3 middle = Vector3::Zero();
    for (int t = 0; graph.component(t) == 0; ++t)
        middle += graph.area(t) * graph.centroid(t) / 600.0;
    for (int t = 0; graph.component(t) == 0; ++t)
        EXPECT_GT(graph.normal(t).dot(graph.centroid(t) - middle), 4.9);
}

TEST(FacetGraph, JoinsFacetsOfSolidsOnlyWhereTheyAreOrientedAlike)
{
    const TriangleMesh box = shapes::box(2, Vector3(10.0, 10.0, 10.0));
    const std::size_t edges = static_cast<std::size_t>(box.triangle_count()) * 3 / 2;
    double length = 0.0;
    for (const FacetJoint& joint : FacetGraph::of_solids(box).joints())
        length += joint.bend > 0.1 ? joint.length : 0.0;
    EXPECT_NEAR(length, 12 * 10.0, 1e-9);
    EXPECT_EQ(FacetGraph::of_solids(box).joints().size(), edges);
    Triangles turned = box.triangles();
    std::swap(turned(0, 0), turned(0, 1));
    const TriangleMesh torn(box.points(), turned);
    EXPECT_EQ(FacetGraph::of_solids(torn).joints().size(), edges - 3);
    EXPECT_EQ(FacetGraph(torn, 1e-7).joints().size(), edges);
    EXPECT_FALSE(FacetGraph::of_solids(torn).is_closed(0));
}

}  // namespace

}  // namespace sheetmorph::recognise

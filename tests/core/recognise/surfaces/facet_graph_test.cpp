// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces/facet_graph.h"

#include "shapes/plates.h"
#include "shapes/solids.h"
#include "shapes/variations.h"

#include <gtest/gtest.h>

namespace sheetmorph
{

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

}  // namespace

}  // namespace sheetmorph

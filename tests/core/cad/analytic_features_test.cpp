// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/analytic_features.h"
#include "sheetmorph/cad/reading/cad_reader.h"
#include "sheetmorph/fitting/circle.h"
#include "cad_files.h"

#include <gtest/gtest.h>

namespace sheetmorph::cad::test
{

namespace
{

std::vector<CadFeature> of_kind(const CadPart& part, CadFeatureKind kind)
{
    std::vector<CadFeature> found;
    for (const CadFeature& feature : analytic_features(part))
        if (feature.kind == kind)
            found.push_back(feature);
    return found;
}

void expect_near(const Vector3& found, const Vector3& expected, double tolerance)
{
    EXPECT_LT((found - expected).norm(), tolerance) << found.transpose();
}

}  // namespace

TEST(AnalyticFeatures, give_holes_of_a_step_file_to_rounding_at_any_coarseness)
{
    const TemporaryFolder folder;
    write_plate_step(folder.file("plate.step"));
    for (const double angle : {0.1, 0.35, 0.7})
    {
        const CadModel model = read_cad(folder.file("plate.step"), {8.0, 1.0, angle}, Progress());
        const auto holes = of_kind(model.parts[0], CadFeatureKind::round_hole);
        ASSERT_EQ(holes.size(), 2u);
        const CadFeature& wide = holes[holes[0].radius > 4 ? 0 : 1];
        EXPECT_NEAR(wide.radius, 5.0, 1e-13);
        expect_near(wide.centre, {40, 20, 1}, 1e-12);
        expect_near(wide.axis, {0, 0, 1}, 1e-13);
        EXPECT_NEAR(wide.length, 2.0, 1e-12);
        EXPECT_LT(wide.residual, 1e-12);
        EXPECT_EQ(of_kind(model.parts[0], CadFeatureKind::plane).size(), 6u);

        // A bare mesh knows the circle through its vertices, and the chords inside it.
        Points rim(static_cast<Eigen::Index>(wide.vertices.size()), 3);
        Eigen::Index count = 0;
        for (const int v : wide.vertices)
            if (model.parts[0].mesh.points()(v, 2) > 1.9)
                rim.row(count++) = model.parts[0].mesh.points().row(v);
        const Points upper = rim.topRows(count);
        const double chordal = 5.0 * (1.0 - std::cos(0.5 * angle));
        EXPECT_NEAR(fitting::fit_circle(upper).radius, 5.0, chordal);
    }
}

TEST(AnalyticFeatures, tell_holes_from_pins_and_bends)
{
    const TemporaryFolder folder;
    write_assembly_step(folder.file("fixture.step"));
    const CadModel model = read_cad(folder.file("fixture.step"), {5.0, 0.1, 0.35}, Progress());
    EXPECT_TRUE(of_kind(model.parts[2], CadFeatureKind::round_hole).empty());
    const auto pins = of_kind(model.parts[2], CadFeatureKind::cylinder);
    ASSERT_EQ(pins.size(), 1u);
    EXPECT_FALSE(pins[0].is_hollow);
    expect_near(pins[0].axis, {0, 1, 0}, 1e-13);
    expect_near(pins[0].centre, {40, 16, -3}, 1e-12);
    write_bend_brep(folder.file("bend.brep"));
    const CadPart bend =
        read_cad(folder.file("bend.brep"), {5.0, 0.1, 0.35}, Progress()).parts.at(0);
    EXPECT_TRUE(of_kind(bend, CadFeatureKind::round_hole).empty());
    const auto cylinders = of_kind(bend, CadFeatureKind::cylinder);
    ASSERT_EQ(cylinders.size(), 2u);
    EXPECT_NE(cylinders[0].is_hollow, cylinders[1].is_hollow);
}

TEST(AnalyticFeatures, find_the_rims_of_a_sheet_without_thickness)
{
    const TemporaryFolder folder;
    write_sheet_and_ball_brep(folder.file("both.brep"));
    const CadModel model = read_cad(folder.file("both.brep"), {5.0, 0.1, 0.35}, Progress());
    const auto holes = of_kind(model.parts[1], CadFeatureKind::round_hole);
    ASSERT_EQ(holes.size(), 2u);
    EXPECT_NEAR(holes[0].radius + holes[1].radius, 8.0, 1e-13);
    EXPECT_GE(holes[0].vertices.size(), 18u);
    const auto balls = of_kind(model.parts[0], CadFeatureKind::sphere);
    ASSERT_EQ(balls.size(), 1u);
    EXPECT_NEAR(balls[0].radius, 4.0, 1e-13);
    expect_near(balls[0].centre, {100, 0, 0}, 1e-12);
}

TEST(AnalyticFeatures, know_cones_and_splines)
{
    const TemporaryFolder folder;
    write_solids_brep(folder.file("solids.brep"));
    const CadModel model = read_cad(folder.file("solids.brep"), {2.0, 0.1, 0.35}, Progress());
    const auto cones = of_kind(model.parts[0], CadFeatureKind::cone);
    ASSERT_EQ(cones.size(), 1u);
    EXPECT_NEAR(cones[0].half_angle, std::atan(0.5), 1e-13);
    EXPECT_LT(cones[0].residual, 1e-12);
    const auto pins = of_kind(model.parts[2], CadFeatureKind::cylinder);
    ASSERT_EQ(pins.size(), 1u);
    EXPECT_NEAR(pins[0].radius, 5.0, 1e-5);
    EXPECT_LT(pins[0].residual, 1e-4);
}

}  // namespace sheetmorph::cad::test

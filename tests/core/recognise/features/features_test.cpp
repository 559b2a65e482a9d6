// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/features.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"
#include "shapes/plates.h"
#include "shapes/thick.h"
#include "shapes/thin.h"
#include "shapes/variations.h"

#include <gtest/gtest.h>

namespace sheetmorph::recognise
{

using namespace mesh;

namespace
{

std::vector<Feature> of_kind(const std::vector<Feature>& features, FeatureKind kind)
{
    std::vector<Feature> found;
    for (const Feature& feature : features)
        if (feature.kind == kind)
            found.push_back(feature);
    return found;
}

TEST(Features, RoundHolesOfASheetAreFoundToRounding)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const auto holes = of_kind(find_features(plate.mesh), FeatureKind::round_hole);
    ASSERT_EQ(holes.size(), plate.rims.size());
    for (std::size_t k = 0; k < holes.size(); ++k)
    {
        EXPECT_NEAR(holes[k].radius, 12.0, 1e-10);
        EXPECT_NEAR(std::abs(holes[k].axis.z()), 1.0, 1e-12);
        VertexIds rim = plate.rims[k];
        std::sort(rim.begin(), rim.end());
        EXPECT_EQ(holes[k].vertices, rim);
        EXPECT_EQ(holes[k].washer.front().size(), rim.size());
    }
}

TEST(Features, AHoleThroughAThinSolidIsOneHoleWithTwoRims)
{
    for (const int rim : {8, 16, 64})
    {
        shapes::PlateSpec spec;
        spec.rim = rim;
        const auto plate = shapes::thickened(shapes::plate_with_holes(spec).mesh, 2.0);
        const auto holes = of_kind(find_features(plate), FeatureKind::round_hole);
        ASSERT_EQ(holes.size(), 3u) << rim;
        for (const Feature& hole : holes)
        {
            EXPECT_EQ(hole.rims.size(), 2u);
            EXPECT_EQ(hole.vertices.size(), 2u * rim);
            EXPECT_NEAR(hole.depth, 2.0, 1e-9);
            EXPECT_NEAR(hole.radius, 12.0, 1e-9);
        }
    }
}

TEST(Features, UnweldedTrianglesGiveTheSameHoles)
{
    const auto plate = shapes::thickened(shapes::plate_with_holes().mesh, 2.0);
    const TriangleMesh soup = shapes::unwelded(plate);
    const auto holes = of_kind(find_features(soup), FeatureKind::round_hole);
    ASSERT_EQ(holes.size(), 3u);
    for (const Feature& hole : holes)
        EXPECT_GT(hole.vertices.size(), 64u);  // every corner at both rims
}

TEST(Features, NoiseOfSomePercentHidesNoHole)
{
    for (unsigned seed = 0; seed < 5; ++seed)
    {
        const auto plate = shapes::plate_with_holes();
        const auto noisy = shapes::jittered(plate.mesh, 0.25, seed);
        EXPECT_EQ(of_kind(find_features(noisy), FeatureKind::round_hole).size(), 3u) << seed;
    }
}

TEST(Features, HolesOfAMeasuredPlateAreFoundByTheirRims)
{
    for (unsigned seed = 0; seed < 5; ++seed)
    {
        const auto plate = shapes::plate_with_holes();
        const auto holes = of_kind(find_features(shapes::scattered(plate.mesh, 0.25, seed)),
                                   FeatureKind::round_hole);
        ASSERT_EQ(holes.size(), plate.rims.size()) << seed;
        for (std::size_t k = 0; k < holes.size(); ++k)
        {
            VertexIds rim = plate.rims[k];
            std::sort(rim.begin(), rim.end());
            EXPECT_EQ(holes[k].vertices, rim);
            EXPECT_NEAR(holes[k].radius, 12.0, 0.25);
        }
    }
}

TEST(Features, SlotsAndRectanglesAreToldFromCircles)
{
    const auto stretched = [](double along)
    {
        return shapes::mapped(shapes::annulus(32, 3, 10.0, 40.0), [=](Vector3 p)
                              { return Vector3(p + Vector3(p.x() > 0 ? along : -along, 0, 0)); });
    };
    const auto slots = of_kind(find_features(stretched(15.0)), FeatureKind::slotted_hole);
    ASSERT_EQ(slots.size(), 1u);
    EXPECT_NEAR(slots[0].width, 20.0, 0.2);
    EXPECT_NEAR(slots[0].length, 50.0, 0.2);
    const auto square = shapes::mapped(shapes::annulus(32, 3, 10.0, 40.0),
                                       [](Vector3 p)
                                       {
                                           const double out = p.cwiseAbs().maxCoeff() / p.norm();
                                           return Vector3((p.norm() < 11.0 ? 1.0 / out : 1.0) * p);
                                       });
    const auto rectangles = of_kind(find_features(square), FeatureKind::rectangular_hole);
    ASSERT_EQ(rectangles.size(), 1u);
    EXPECT_NEAR(rectangles[0].width, 20.0, 0.3);
}

TEST(Features, TheBorderOfADiscAndTheEndsOfATubeAreNoHoles)
{
    const auto disc = find_features(shapes::annulus(24, 4, 5.0, 30.0));
    EXPECT_EQ(of_kind(disc, FeatureKind::round_hole).size(), 1u);
    EXPECT_EQ(of_kind(disc, FeatureKind::round_edge).size(), 1u);
    const auto tube = find_features(shapes::cylinder(24, 6, 10.0, 50.0));
    EXPECT_EQ(of_kind(tube, FeatureKind::round_hole).size(), 0u);
    EXPECT_EQ(of_kind(tube, FeatureKind::round_edge).size(), 2u);
}

TEST(Features, TheAnswerDoesNotDependOnNumbersAndPlace)
{
    const auto plate = shapes::thickened(shapes::plate_with_holes().mesh, 2.0);
    const auto before = find_features(plate);
    const auto shuffled = shapes::renumbered(plate, 7);
    const Matrix3 turn = rotation_from_log(Vector3(0.3, -0.7, 1.1));
    const auto after =
        find_features(shapes::mapped(shuffled.mesh, [&](const Vector3& p)
                                     { return Vector3(turn * p + Vector3(2e4, -3e4, 1e4)); }));
    ASSERT_EQ(before.size(), after.size());
    for (const Feature& one : before)
    {
        VertexIds expected;
        for (const int vertex : one.vertices)
            expected.push_back(shuffled.new_id[vertex]);
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(std::count_if(after.begin(), after.end(),
                                [&](const Feature& other)
                                { return other.kind == one.kind && other.vertices == expected; }),
                  1);
    }
}

TEST(Features, RadiiOutOfTheRangeAreLeftOut)
{
    const auto plate = shapes::plate_with_holes().mesh;  // radius 12 mm
    const auto slot =
        shapes::mapped(shapes::annulus(32, 3, 10.0, 40.0), [](Vector3 p)
                       { return Vector3(p + Vector3(p.x() > 0 ? 15.0 : -15.0, 0, 0)); });
    const auto count = [](const TriangleMesh& mesh, FeatureKind kind, double least, double most)
    {
        FeatureTolerances tolerances;
        tolerances.smallest_radius = least;
        tolerances.largest_radius = most;
        return of_kind(find_features(mesh, tolerances), kind).size();
    };
    for (const bool is_solid : {false, true})
    {
        const TriangleMesh part = is_solid ? shapes::thickened(plate, 2.0) : plate;
        EXPECT_EQ(count(part, FeatureKind::round_hole, 11.9, 12.1), 3u);
        EXPECT_EQ(count(part, FeatureKind::round_hole, 12.1, 100.0), 0u);
        EXPECT_EQ(count(part, FeatureKind::round_hole, 0.0, 11.9), 0u);
    }
    EXPECT_EQ(count(slot, FeatureKind::slotted_hole, 9.5, 10.5), 1u);
    EXPECT_EQ(count(slot, FeatureKind::slotted_hole, 10.5, 100.0), 0u);
    EXPECT_EQ(count(slot, FeatureKind::slotted_hole, 0.0, 9.5), 0u);
}

// A round solid: a profile of (radius, height) from the axis above to the axis below, turned about
// z.
TriangleMesh turned_solid(const std::vector<Eigen::Vector2d>& profile)
{
    constexpr int around = 32;
    const int rings = static_cast<int>(profile.size());
    Points points(2 + around * (rings - 2), 3);
    points.row(0) << 0.0, 0.0, profile.front().y();
    points.row(1) << 0.0, 0.0, profile.back().y();
    for (int ring = 1; ring + 1 < rings; ++ring)
        for (int k = 0; k < around; ++k)
        {
            const double angle = 2.0 * shapes::pi * k / around;
            const Eigen::Vector2d& place = profile[static_cast<std::size_t>(ring)];
            points.row(2 + around * (ring - 1) + k) << place.x() * std::cos(angle),
                place.x() * std::sin(angle), place.y();
        }
    std::vector<Eigen::RowVector3i> corners;
    for (int k = 0; k < around; ++k)
    {
        const int next = (k + 1) % around, last = 2 + around * (rings - 3);
        corners.emplace_back(0, 2 + k, 2 + next);
        corners.emplace_back(1, last + next, last + k);
        for (int row = 2; row < last; row += around)
        {
            corners.emplace_back(row + k, row + around + k, row + around + next);
            corners.emplace_back(row + k, row + around + next, row + next);
        }
    }
    Triangles triangles(corners.size(), 3);
    for (std::size_t t = 0; t < corners.size(); ++t)
        triangles.row(t) = corners[t];
    return TriangleMesh(points, triangles);
}

TEST(Features, ABlindHoleGoesIntoTheMaterialAndABossStandsOutOfIt)
{
    const auto blind = find_features(turned_solid({{0, -4},
                                                   {4, -4},
                                                   {8, -4},
                                                   {8, -2},
                                                   {8, 0},
                                                   {20, 0},
                                                   {40, 0},
                                                   {40, -10},
                                                   {20, -10},
                                                   {0, -10}}));
    const auto holes = of_kind(blind, FeatureKind::round_hole);
    ASSERT_EQ(holes.size(), 1u);
    EXPECT_NEAR(holes[0].radius, 8.0, 1e-9);
    EXPECT_NEAR(holes[0].depth, 4.0, 1e-9);
    EXPECT_TRUE(of_kind(blind, FeatureKind::emboss).empty());
    const auto boss = find_features(turned_solid({{0, 4},
                                                  {4, 4},
                                                  {8, 4},
                                                  {8, 2},
                                                  {8, 0},
                                                  {20, 0},
                                                  {40, 0},
                                                  {40, -10},
                                                  {20, -10},
                                                  {0, -10}}));
    EXPECT_TRUE(of_kind(boss, FeatureKind::round_hole).empty());
    ASSERT_EQ(of_kind(boss, FeatureKind::emboss).size(), 1u);
    EXPECT_NEAR(of_kind(boss, FeatureKind::emboss)[0].depth, 4.0, 1e-9);
}

// A sheet of 40 mm wide with one bend about y; its skins are that far from the axis.
TEST(Features, ABendHasItsTurnItsRadiusAndItsThickness)
{
    const TriangleMesh flat = shapes::grid(24, 12, 120.0, 40.0);
    for (const double turn : {0.5, 1.0, -1.2, shapes::pi / 2.0})
    {
        const double arc = 20.0, radius = arc / std::abs(turn), thickness = 1.5;
        const TriangleMesh sheet = shapes::with_bend(flat, 50.0, arc, turn);
        const auto bends = of_kind(find_features(sheet), FeatureKind::bend);
        ASSERT_EQ(bends.size(), 1u) << turn;
        EXPECT_NEAR(bends[0].angle, std::abs(turn), 1e-6);
        EXPECT_NEAR(bends[0].radius, radius, 1e-6 * radius);
        EXPECT_NEAR(bends[0].length, 40.0, 1e-6);
        EXPECT_NEAR(std::abs(bends[0].axis.y()), 1.0, 1e-9);
        // The solid is below the sheet: the sheet is the inner skin where it turns up.
        const TriangleMesh solid = shapes::two_skinned(sheet, thickness);
        const auto both = of_kind(find_features(solid), FeatureKind::bend);
        ASSERT_EQ(both.size(), 1u) << turn;
        EXPECT_NEAR(both[0].angle, std::abs(turn), 0.02);
        EXPECT_NEAR(both[0].depth, thickness, 0.02 * thickness);
        EXPECT_NEAR(both[0].radius, turn > 0.0 ? radius : radius - thickness, 0.02 * radius);
    }
}

TEST(Features, ToleranceOutOfRangeIsNamed)
{
    FeatureTolerances tolerances;
    tolerances.roundness = 2.0;
    EXPECT_THROW(find_features(shapes::grid(2, 2, 1.0, 1.0), tolerances), InvalidInput);
}

TEST(Features, AnEmptyMeshHasNone)
{
    EXPECT_TRUE(find_features(TriangleMesh()).empty());
}

}  // namespace

}  // namespace sheetmorph::recognise

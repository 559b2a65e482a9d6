// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/features/features.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"
#include "shapes/plates.h"
#include "shapes/thick.h"
#include "shapes/variations.h"

#include <gtest/gtest.h>

namespace sheetmorph
{

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

}  // namespace sheetmorph

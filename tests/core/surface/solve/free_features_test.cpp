// SPDX-License-Identifier: LGPL-2.1-or-later
// Features that the energy turns.
#include "surface/free_strip.h"

#include <gmock/gmock.h>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

TEST(FreeFeatures, ALiftedStripBendsLikeThePlateWithoutHoles)
{
    Case one = strip_with_holes();
    const Deformation shape = solve(one);
    for (const double s : {0.125, 0.25, 0.375, 0.5})
        EXPECT_NEAR(height_at(one, shape.positions, 300.0 * s) / 60.0, s * s * (3.0 - 2.0 * s),
                    0.04);
    EXPECT_NEAR(tilt(shape.features[0]), tilt(shape.features[2]), 1e-6);
    // The slope of the cubic at 1/2 and 1/6.
    EXPECT_NEAR(tilt(shape.features[1]), 16.7, 1.0);
    EXPECT_NEAR(tilt(shape.features[0]), 9.5, 1.0);
}

TEST(FreeFeatures, TheSheetBendsFarLessThanBetweenParallelFeatures)
{
    for (const bool is_curved : {false, true})
    {
        Case one = strip_with_holes(is_curved);
        const double free = bending(one, solve(one).positions);
        set_rotation(one, FeatureRotation::interpolated);
        EXPECT_GT(bending(one, solve(one).positions), 4.0 * free) << is_curved;
    }
}

TEST(FreeFeatures, ATwistedStripSharesTheTurnAsItsGapsAreStiff)
{
    Case one = strip_with_holes();
    one.targets.handles = {
        cases::motion(Vector3::Zero(), {1.0, 0.0, 0.0}, 170.0, {300.0, 50.0, 0.0})};
    const Deformation shape = solve(one);
    // Gaps of 30, 60, 60 and 30 mm are as stiff as 8 : 1 : 1 : 8.
    const double angles[] = {170.0 / 18.0, 85.0, 170.0 * 17.0 / 18.0};
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(2.0 * shape.features[k].rotation_log.norm() / degree, angles[k], 4.0);
}

TEST(FreeFeatures, AHandleTurnedBeyondAWholeTurnNeverLeaps)
{
    Case one = strip_with_holes();
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    const auto pose = [&](double degrees)
    {
        one.targets.handles = {
            cases::motion(Vector3::Zero(), {1.0, 0.1, 0.0}, degrees, {300.0, 50.0, 0.0})};
        return deformer.deform(one.targets, Exactness::live).positions;
    };
    Points last = pose(0.0);
    for (double degrees = 4.0; degrees <= 400.0; degrees += 4.0)
    {
        const Points next = pose(degrees);
        EXPECT_LT((next - last).rowwise().norm().maxCoeff(), 25.0) << degrees;
        last = next;
    }
}

TEST(FreeFeatures, AHandleWithAFreeRotationTurnsAsTheSheetWants)
{
    Case one = cases::strip(40);
    one.constraints.handles[0].is_rotation_free = true;
    one.targets.handles[0].pivot = {100.0, 12.5, 0.0};
    const Deformation shape = solve(one);
    const auto& vertices = one.constraints.handles[0].vertices;
    Vector3 moved = Vector3::Zero();
    for (const int vertex : vertices)
        moved += shape.positions.row(vertex).transpose() / static_cast<double>(vertices.size());
    EXPECT_LT((moved - Vector3(100.0, 12.5, 10.0)).norm(), 1e-10);
    // Held flat it is a cubic with a level end; free, the middle hangs lower.
    const double free_middle = height_at(one, shape.positions, 50.0);
    one.constraints.handles[0].is_rotation_free = false;
    EXPECT_LT(free_middle, height_at(one, solve(one).positions, 50.0) - 0.2);
}

}  // namespace
}  // namespace sheetmorph::surface

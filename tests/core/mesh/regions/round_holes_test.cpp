// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/regions/round_holes.h"

#include "sheetmorph/base/errors.h"

#include "shapes/plates.h"
#include "shapes/variations.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sheetmorph::mesh
{

using testing::SizeIs;

TEST(RoundHoles, OfAPlateAreItsHolesAndNotItsBorder)
{
    const shapes::PlateWithHoles plate = shapes::plate_with_holes();
    const auto holes = round_holes(plate.mesh, 1e-6);
    ASSERT_THAT(holes, SizeIs(3));
    for (const RoundHole& hole : holes)
    {
        EXPECT_THAT(hole.rim, SizeIs(32));
        EXPECT_NEAR(hole.circle.radius, 12.0, 1e-12);
        EXPECT_NEAR(hole.circle.centre.y(), 30.0, 1e-12);
    }
}

TEST(RoundHoles, SkipTheBorderOfANarrowCurvedStrip)
{
    const TriangleMesh strip =
        shapes::mapped(shapes::grid(40, 1, 1.0, 1.0),
                       [](const Vector3& p)
                       {
                           const double radius = 100.0 + 0.2 * p.y();
                           return Vector3(radius * std::cos(p.x()), radius * std::sin(p.x()), 0.0);
                       });
    const fitting::CircleFit circle = fitting::fit_circle(strip.points());
    EXPECT_LT(circle.residual, 0.01 * circle.radius);
    EXPECT_THAT(round_holes(strip, 0.01), SizeIs(0));
}

TEST(RoundHoles, SkipOvalsSlitsAndCoarseOnes)
{
    const auto stretch = [](const Vector3& p) { return Vector3(1.05 * p.x(), p.y(), p.z()); };
    const TriangleMesh ring = shapes::annulus(24, 2, 5, 8);
    EXPECT_THAT(round_holes(ring, 0.01), SizeIs(2));
    EXPECT_THAT(round_holes(shapes::mapped(ring, stretch), 0.01), SizeIs(0));
    const auto flatten = [](const Vector3& p) { return Vector3(p.x(), 0.0, 0.0); };
    EXPECT_THAT(round_holes(shapes::mapped(ring, flatten), 0.5), SizeIs(0));
    EXPECT_THAT(round_holes(shapes::annulus(5, 2, 5, 8), 0.01), SizeIs(0));
    EXPECT_THROW(round_holes(ring, 0.0), InvalidInput);
}

}  // namespace sheetmorph::mesh

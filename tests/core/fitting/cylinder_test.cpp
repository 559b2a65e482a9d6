// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/cylinder.h"

#include "sheetmorph/mesh/geometry/facets.h"

#include "sheetmorph/base/rotation.h"
#include "shapes/sheets.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::fitting
{

using namespace mesh;
namespace
{

// Part of a tube of radius 5 mm about z, its vertices drawn on it: the normals of its triangles are
// at right angles to the axis only roughly.
TriangleMesh drawn_tube(double share_of_turn, double height, unsigned seed)
{
    std::mt19937 bits(seed);
    std::uniform_real_distribution<double> nudge(-0.2, 0.2);
    constexpr int around = 14, along = 5;
    return shapes::sheet({around, along},
                         [&](double u, double v)
                         {
                             const double angle =
                                 2.0 * shapes::pi * share_of_turn * (u + nudge(bits) / around);
                             const double z = height * (v + nudge(bits) / along);
                             return Vector3(5.0 * std::cos(angle), 5.0 * std::sin(angle), z);
                         });
}

TEST(CylinderFit, ACylinderIsFoundExactlyWhereverItsVerticesLieOnIt)
{
    for (unsigned seed = 1; seed <= 12; ++seed)
        for (const double share : {0.25, 0.5, 0.9})
        {
            const Matrix3 turn = rotation_from_log(Vector3(0.2 * seed, -0.5, 0.3 * seed));
            const Vector3 shift(10.0 * seed, -20.0, 30.0);
            const TriangleMesh tube = drawn_tube(share, 4.0, seed);
            const TriangleMesh moved(
                (tube.points() * turn.transpose()).rowwise() + shift.transpose(), tube.triangles());
            const auto found = fit_cylinder(facets_of(moved));
            ASSERT_TRUE(found) << seed << ' ' << share;
            EXPECT_NEAR(found->radius, 5.0, 1e-8);
            const Vector3 axis = turn.col(2);
            EXPECT_LT(found->frame.col(2).cross(axis).norm(), 1e-8);
            EXPECT_LT((found->centre - shift).cross(axis).norm(), 1e-7);
        }
}

TEST(CylinderFit, FlatSheetsConesAndSpheresAreNone)
{
    EXPECT_FALSE(fit_cylinder(facets_of(shapes::grid(6, 6, 10.0, 10.0))));
    const TriangleMesh cone = shapes::sheet(
        {16, 4, true, false},
        [](double u, double v)
        {
            const double angle = 2.0 * shapes::pi * u, radius = 5.0 + v;
            return Vector3(radius * std::cos(angle), radius * std::sin(angle), 3.0 * v);
        });
    EXPECT_FALSE(fit_cylinder(facets_of(cone)));
}

}  // namespace
}  // namespace sheetmorph::fitting

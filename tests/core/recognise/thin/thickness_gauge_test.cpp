// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/thickness_gauge.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"
#include "shapes/thin.h"

#include <gtest/gtest.h>

namespace sheetmorph::recognise
{
namespace
{

struct Plate
{
    mesh::TriangleMesh mesh = shapes::two_skinned(shapes::grid(20, 10, 100.0, 50.0), 2.0);
    ThinSolid solid = *find_thin_solid(mesh).solid;

    // The thickness of the plate times a factor that may depend on the place.
    template <typename Factor>
    ThicknessChange thickened(Factor factor) const
    {
        Points positions = mesh.points();
        for (Eigen::Index i = 0; i < positions.rows(); ++i)
            positions(i, 2) *= factor(positions(i, 0));
        return thickness_change(mesh, solid, positions);
    }
};

TEST(ThicknessGauge, MeasuresThickerAndThinnerPlates)
{
    const Plate plate;
    for (const double factor : {0.5, 0.8, 1.0, 1.5})
    {
        const ThicknessChange change = plate.thickened([=](double) { return factor; });
        EXPECT_NEAR(change.rest_least, 2.0, 1e-9);
        EXPECT_NEAR(change.rest_most, 2.0, 1e-9);
        EXPECT_NEAR(change.least, 2.0 * factor, 1e-9);
        EXPECT_NEAR(change.most, 2.0 * factor, 1e-9);
        EXPECT_NEAR(change.worst, std::abs(factor - 1.0), 1e-9);
        EXPECT_NEAR(change.worst_at_walls, std::abs(factor - 1.0), 1e-9);
    }
}

TEST(ThicknessGauge, NamesThePlaceOfTheLargestChange)
{
    const Plate plate;
    const ThicknessChange change =
        plate.thickened([](double x) { return x > 49.0 && x < 51.0 ? 0.7 : 1.0; });
    ASSERT_GE(change.place.vertex, 0);
    EXPECT_NEAR(plate.mesh.points()(change.place.vertex, 0), 50.0, 1e-9);
    EXPECT_NEAR(change.place.rest, 2.0, 1e-9);
    EXPECT_NEAR(change.place.deformed, change.least, 1e-12);
    EXPECT_LT(change.least, 1.5);
}

TEST(ThicknessGauge, RigidMotionsChangeNothing)
{
    const Plate plate;
    const Matrix3 turn = rotation_from_log(Vector3(0.4, -0.8, 0.3));
    const Points moved =
        (plate.mesh.points() * turn.transpose()).rowwise() + Eigen::RowVector3d(100, -50, 30);
    const ThicknessChange change = thickness_change(plate.mesh, plate.solid, moved);
    EXPECT_LT(change.worst, 1e-9);
    EXPECT_LT(change.worst_at_walls, 1e-9);
}

TEST(ThicknessGauge, RefusesPositionsOfAnotherMesh)
{
    const Plate plate;
    EXPECT_THROW(thickness_change(plate.mesh, plate.solid, Points::Zero(3, 3)), InvalidInput);
    EXPECT_THROW(thickness_change(shapes::grid(2, 2, 1.0, 1.0), plate.solid, plate.mesh.points()),
                 InvalidInput);
}

}  // namespace
}  // namespace sheetmorph::recognise

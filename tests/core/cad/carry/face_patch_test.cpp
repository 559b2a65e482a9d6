// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/face_patch.h"
#include "sheetmorph/cad/splines/spline_curve.h"

#include <Geom2d_Line.hxx>
#include <Geom_Plane.hxx>
#include <gp_Dir2d.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

namespace sheetmorph::cad
{

namespace
{

// A border of 10 mm from a corner of a plane, that of a curve with one knot.
FaceBorder border(const gp_Dir2d& along)
{
    const CubicBasis basis(0.0, 10.0, {{4.0, 1}});
    FaceBorder found;
    found.curve = new Geom2d_Line(gp_Pnt2d(1.0, 2.0), along);
    found.high = 10.0;
    found.target = SplineCurve{basis, Eigen::MatrixXd::Zero(basis.count(), 3)}.curve();
    return found;
}

SurfacePatch plane_within(const FaceBorder& one)
{
    return surface_patch(new Geom_Plane(gp_Pln()), {one});
}

}  // namespace

TEST(FacePatch, HasTheKnotsOfCurvesAlongItsParameters)
{
    const SurfacePatch patch = plane_within(border(gp_Dir2d(0.0, -1.0)));
    EXPECT_TRUE(patch.knots[0].empty());
    ASSERT_EQ(patch.knots[1].size(), 1U);
    EXPECT_NEAR(patch.knots[1][0].at, -2.0, 1e-12);
    EXPECT_NEAR(patch.knots[1][0].spacing, 4.0, 1e-12);
}

TEST(FacePatch, HasNoKnotsOfCurvesThatGoAslant)
{
    const SurfacePatch patch = plane_within(border(gp_Dir2d(1.0, 1.0)));
    EXPECT_TRUE(patch.knots[0].empty() && patch.knots[1].empty());
}

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/parameter_curve.h"

#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

namespace sheetmorph
{

namespace
{

const Handle(Geom_CylindricalSurface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 5.0);
const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, 2), gp::DZ()), 5.001);

// Of the circle, as a file has it that is off by so much along and across the circle, mm.
Handle(Geom2d_Curve) beneath(double along, double across, double tolerance)
{
    const Handle(Geom2d_Line) of_file =
        new Geom2d_Line(gp_Pnt2d(along / 5.0, 2.0 + across), gp_Dir2d(1.0, 0.0));
    return curve_beneath(circle, cylinder, of_file, 0.2, 1.4, tolerance);
}

}  // namespace

TEST(CurveBeneath, IsThatOfTheFileWhereItIsNear)
{
    EXPECT_FALSE(Handle(Geom2d_Line)::DownCast(beneath(0.0, 0.0, 1e-4)).IsNull());
    EXPECT_FALSE(Handle(Geom2d_Line)::DownCast(beneath(5e-5, 5e-5, 1e-4)).IsNull());
}

TEST(CurveBeneath, HasTheParametersOfThePointsBeneathElse)
{
    for (const auto& [along, across] : {std::pair(0.003, 0.0), {0.0, 0.002}, {-0.001, 0.004}})
    {
        const Handle(Geom2d_Curve) found = beneath(along, across, 1e-4);
        for (const double t : {0.2, 0.33, 0.9, 1.4})
        {
            EXPECT_NEAR(found->Value(t).X(), t, 2e-5 / 5.0);
            EXPECT_NEAR(found->Value(t).Y(), 2.0, 2e-5);
        }
    }
}

}  // namespace sheetmorph

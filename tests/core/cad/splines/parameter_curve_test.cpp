// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/parameter_curve.h"

#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

namespace sheetmorph::cad
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

// A flat patch whose parameters are at 53 degrees to each other: x = 10 u + 6 v, y = 8 v.
TEST(CurveBeneath, HasTheParametersOfSkewedSurfaces)
{
    TColgp_Array2OfPnt corners(1, 2, 1, 2);
    for (const int u : {0, 1})
        for (const int v : {0, 1})
            corners.SetValue(u + 1, v + 1, gp_Pnt(10.0 * u + 6.0 * v, 8.0 * v, 0.0));
    const Handle(Geom_BezierSurface) patch = new Geom_BezierSurface(corners);
    const Handle(Geom_Circle) round = new Geom_Circle(gp_Ax2(gp_Pnt(8, 4, 0), gp::DZ()), 2.0);
    const Handle(Geom2d_Line) of_file = new Geom2d_Line(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1.0, 0.2));
    const auto found = curve_beneath(round, patch, of_file, 0.0, 0.4, 1e-5);
    for (const double t : {0.0, 0.1, 0.27, 0.4})
    {
        const gp_Pnt above = round->Value(t);
        EXPECT_NEAR(found->Value(t).Y(), above.Y() / 8.0, 1e-6);
        EXPECT_NEAR(found->Value(t).X(), (above.X() - 0.75 * above.Y()) / 10.0, 1e-6);
    }
}

// A flat patch, x = 2 u and y = 3 v, and the border x = 2 from one v to another.
Handle(Geom_BSplineCurve) border_of_patch(double from, double to)
{
    TColgp_Array2OfPnt corners(1, 2, 1, 2);
    for (const int u : {0, 1})
        for (const int v : {0, 1})
            corners.SetValue(u + 1, v + 1, gp_Pnt(2.0 * u, 3.0 * v, 0.0));
    const Handle(Geom_BSplineSurface) patch =
        GeomConvert::SurfaceToBSplineSurface(new Geom_BezierSurface(corners));
    const double way = to > from ? 1.0 : -1.0;
    const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(1.0, from), gp_Dir2d(0.0, way));
    return border_above(line, patch, 0.0, way * (to - from));
}

TEST(BorderAbove, RunsBetweenTheEndsOfTheCurve)
{
    for (const auto& [from, to] : {std::pair(0.0, 1.0), {1.0, 0.0}, {0.2, 0.7}, {0.9, 0.1}})
    {
        const auto border = border_of_patch(from, to);
        ASSERT_FALSE(border.IsNull());
        EXPECT_NEAR(border->Value(border->FirstParameter()).Y(), 3.0 * from, 1e-12);
        EXPECT_NEAR(border->Value(border->LastParameter()).Y(), 3.0 * to, 1e-12);
        EXPECT_NEAR(border->LastParameter() - border->FirstParameter(), std::abs(to - from), 1e-12);
    }
}

// Files round: a curve that ends 4e-9 past the surface was a segment that OpenCASCADE 7.8 refuses.
TEST(BorderAbove, EndsWithTheSurfaceWhereTheCurveIsLongerByRounding)
{
    for (const double past : {1e-12, 2e-9, 8e-9})
        for (const auto& [from, to] : {std::pair(-past, 1.0), {0.0, 1.0 + past}, {1.0 + past, 0.0}})
        {
            const auto border = border_of_patch(from, to);
            ASSERT_FALSE(border.IsNull()) << past;
            EXPECT_NEAR(border->Value(border->FirstParameter()).Y(), 3.0 * from, 1e-7);
            EXPECT_NEAR(border->Value(border->LastParameter()).Y(), 3.0 * to, 1e-7);
        }
}

TEST(BorderAbove, IsNothingWhereTheCurveLeavesTheSurface)
{
    EXPECT_TRUE(border_of_patch(0.0, 1.001).IsNull());
    EXPECT_TRUE(border_of_patch(-0.001, 1.0).IsNull());
    EXPECT_TRUE(border_of_patch(1.5, 2.5).IsNull());
}

}  // namespace sheetmorph::cad

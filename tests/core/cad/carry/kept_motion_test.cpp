// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/kept_motion.h"

#include <Eigen/Geometry>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <cmath>
#include <gtest/gtest.h>

namespace sheetmorph::cad
{

namespace
{

const Eigen::AngleAxisd turn(0.4, Vector3(1.0, 2.0, 3.0).normalized());
const Vector3 shift(10.0, -20.0, 5.0);

// Two rings of points on a cylinder of radius 3 about z.
Points cylinder_points(double radius, double from_x = 0.0)
{
    constexpr int around = 12;
    Points points(2 * around, 3);
    for (int i = 0; i < 2 * around; ++i)
    {
        const double angle = 2.0 * M_PI * i / around;
        points.row(i) << from_x + radius * std::cos(angle), radius * std::sin(angle),
            i < around ? 0.0 : 2.0;
    }
    return points;
}

Points moved(const Points& points)
{
    return (points * turn.toRotationMatrix().transpose()).rowwise() + shift.transpose();
}

Handle(Geom_CylindricalSurface) cylinder(double radius)
{
    return new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), radius);
}

}  // namespace

TEST(KeptMotionTest, ARigidMotionIsFoundAlsoFarFromTheOrigin)
{
    const Points rest = cylinder_points(3.0, 5000.0);
    const auto found = rigid_fit(rest, moved(rest), 1e-9, false);
    ASSERT_TRUE(found);
    const Vector3 place(5003.0, 1.0, 2.0);
    EXPECT_LT((found->point(place) - (turn * place + shift)).norm(), 1e-9);
    EXPECT_EQ(found->scale, 1.0);
}

TEST(KeptMotionTest, WhatIsBentOrStretchedIsNotRigid)
{
    const Points rest = cylinder_points(3.0);
    Points bent = moved(rest);
    bent(3, 2) += 1e-6;
    EXPECT_FALSE(rigid_fit(rest, bent, 1e-7, false));
    EXPECT_FALSE(rigid_fit(rest, 1.001 * rest, 1e-7, false));
}

TEST(KeptMotionTest, AStraightRowTellsTheMotionOfALineButNotOfAFace)
{
    Points row(3, 3);
    row << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 3.0, 0.0, 0.0;
    EXPECT_TRUE(rigid_fit(row, moved(row), 1e-12, true));
    EXPECT_FALSE(rigid_fit(row, moved(row), 1e-12, false));
}

TEST(KeptMotionTest, ACylinderOfAnotherSizeGetsItsRadiusExactly)
{
    const auto found =
        resized_fit(cylinder_points(3.0), moved(cylinder_points(4.5)), 1e-9, cylinder(3.0));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->scale, 1.5, 1e-12);
    const auto after = Handle(Geom_CylindricalSurface)::DownCast(found->surface(cylinder(3.0)));
    ASSERT_FALSE(after.IsNull());
    EXPECT_NEAR(after->Radius(), 4.5, 1e-11);
    const auto circle =
        Handle(Geom_Circle)::DownCast(found->curve(new Geom_Circle(gp_Ax2(gp::XOY()), 3.0)));
    ASSERT_FALSE(circle.IsNull());
    EXPECT_NEAR(circle->Radius(), 4.5, 1e-11);
}

TEST(KeptMotionTest, CurvesThatDoNotFollowAnotherRadiusAreTold)
{
    const auto found =
        resized_fit(cylinder_points(3.0), moved(cylinder_points(4.5)), 1e-9, cylinder(3.0));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->curve(new Geom_Line(gp_Pnt(3, 0, 0), gp::DZ())).IsNull());
    EXPECT_TRUE(found->curve(new Geom_Line(gp_Pnt(3, 0, 0), gp_Dir(0, 1, 1))).IsNull());
    EXPECT_TRUE(found->curve(new Geom_Circle(gp_Ax2(gp_Pnt(1, 0, 0), gp::DZ()), 2.0)).IsNull());
}

TEST(KeptMotionTest, OnlyCylindersGetAnotherSize)
{
    const Handle(Geom_Plane) plane = new Geom_Plane(gp::XOY());
    EXPECT_FALSE(resized_fit(cylinder_points(3.0), cylinder_points(4.5), 1e-9, plane));
}

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/surface_breaks.h"

#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gtest/gtest.h>

namespace sheetmorph::cad
{

namespace
{

// A cubic over 0..2 by 0..1 with a knot at u = 1 as often as its degree: heights of its poles.
SurfacePatch two_pieces(const std::array<double, 7>& heights)
{
    TColgp_Array2OfPnt poles(1, 7, 1, 2);
    for (int i = 1; i <= 7; ++i)
        for (int k = 1; k <= 2; ++k)
            poles.SetValue(i, k, gp_Pnt(i - 1, k, heights[static_cast<std::size_t>(i - 1)]));
    TColStd_Array1OfReal u(1, 3), v(1, 2);
    TColStd_Array1OfInteger u_times(1, 3), v_times(1, 2);
    for (int k = 1; k <= 3; ++k)
    {
        u.SetValue(k, k - 1);
        u_times.SetValue(k, k == 2 ? 3 : 4);
    }
    for (int k = 1; k <= 2; ++k)
    {
        v.SetValue(k, k - 1);
        v_times.SetValue(k, 2);
    }
    SurfacePatch patch;
    patch.surface = new Geom_BSplineSurface(poles, u, v, u_times, v_times, 3, 1);
    patch.high = Vector2(2.0, 1.0);
    return patch;
}

}  // namespace

TEST(SurfaceBreaks, AreNoneWhereAKnotChangesNothing)
{
    EXPECT_TRUE(surface_breaks(two_pieces({0, 0, 0, 0, 0, 0, 0}), 0).empty());
    EXPECT_TRUE(surface_breaks(two_pieces({0, 2, 4, 6, 8, 10, 12}), 0).empty());
}

TEST(SurfaceBreaks, AreAsOftenKnotsAsDerivativesJump)
{
    const auto bent = surface_breaks(two_pieces({0, 0, 0, 0, 0, 1, 3}), 0);
    ASSERT_EQ(bent.size(), 1U);
    EXPECT_DOUBLE_EQ(bent[0].at, 1.0);
    EXPECT_EQ(bent[0].times, 2);
    const auto folded = surface_breaks(two_pieces({0, 0, 0, 0, 1, 2, 3}), 0);
    ASSERT_EQ(folded.size(), 1U);
    EXPECT_EQ(folded[0].times, 3);
    EXPECT_TRUE(surface_breaks(two_pieces({0, 0, 0, 0, 1, 2, 3}), 1).empty());
}

}  // namespace sheetmorph::cad

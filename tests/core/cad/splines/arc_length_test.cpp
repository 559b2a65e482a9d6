// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/arc_length.h"

#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

namespace sheetmorph::cad
{

TEST(ArcLength, OfACircleIsItsAngleTimesItsRadius)
{
    const ArcLength length(new Geom_Circle(gp_Ax2(), 3.0), 0.5, 4.5);
    EXPECT_DOUBLE_EQ(length.at(0.5), 0.0);
    EXPECT_NEAR(length.at(1.7), 3.6, 1e-12);
    EXPECT_NEAR(length.whole(), 12.0, 1e-12);
}

TEST(ArcLength, OfALineIsTheDistanceHoweverUnevenItsParameterIs)
{
    TColgp_Array1OfPnt poles(1, 4);
    for (int k = 1; k <= 4; ++k)
        poles.SetValue(k, gp_Pnt(k == 4 ? 40.0 : k - 1.0, 0.0, 0.0));
    const Handle(Geom_BezierCurve) line = new Geom_BezierCurve(poles);
    const ArcLength length(line, 0.0, 1.0);
    for (const double t : {0.0, 0.1, 0.37, 0.8, 1.0})
        EXPECT_NEAR(length.at(t), line->Value(t).X(), 1e-12);
}

}  // namespace sheetmorph::cad

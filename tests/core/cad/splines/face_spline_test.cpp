// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/face_spline.h"
#include "sheetmorph/base/errors.h"

#include <Geom_Plane.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

namespace sheetmorph
{

namespace
{

SurfacePatch square()
{
    SurfacePatch patch;
    patch.surface = new Geom_Plane(gp_Pln());
    patch.high = Vector2(10.0, 10.0);
    return patch;
}

// Places on a wave that one span cannot follow.
SplineTargets wave()
{
    SplineTargets targets;
    for (int i = 0; i <= 20; ++i)
        for (int k = 0; k <= 20; ++k)
        {
            const Vector2 uv(0.5 * i, 0.5 * k);
            targets.places.push_back(
                {uv, {uv(0), uv(1), 0.3 * std::sin(uv(0)) * std::cos(uv(1))}, 1.0, 1e-3, 0.2});
        }
    return targets;
}

}  // namespace

TEST(FaceSpline, GoesThroughPlacesAndTellsOfEveryRound)
{
    FaceSpline spline(square());
    std::vector<double> told;
    spline.fit(wave(), 1e-3,
               Progress(
                   [&](double fraction, const std::string&)
                   {
                       told.push_back(fraction);
                       return true;
                   }));
    EXPECT_GT(told.size(), 2U);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    for (const SurfacePlace& place : wave().places)
        EXPECT_LT((spline.point(place.uv) - place.target).norm(), 1e-3);
}

TEST(FaceSpline, IsCancelledBetweenItsRounds)
{
    FaceSpline spline(square());
    int rounds = 0;
    const Progress progress([&](double, const std::string&) { return ++rounds < 3; });
    EXPECT_THROW(spline.fit(wave(), 1e-3, progress), Cancelled);
    EXPECT_EQ(rounds, 3);
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/splines/face_spline.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/splines/spline_curve.h"

#include <Geom_Plane.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

namespace sheetmorph::cad
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

// A curve above the border v = 10 with a knot where no half of a span ends.
SplineTargets curve_along_the_border()
{
    const SplineCurve curve = {
        CubicBasis(0.0, 10.0, {{3.7, 1}}),
        (Eigen::MatrixXd(5, 3) << 0, 10, 0, 2, 10, 0.01, 5, 10, -0.02, 8, 10, 0.01, 10, 10, 0)
            .finished()};
    SurfaceTrack track;
    track.uv = [](double t) { return Vector2(t, 10.0); };
    track.target = [curve](double t) { return curve.at(t); };
    track.parameters = {0.0, 5.0, 10.0};
    track.tolerance = 1e-3;
    SplineTargets targets;
    targets.tracks.push_back(track);
    return targets;
}

double largest_gap(const FaceSpline& spline, const SurfaceTrack& track)
{
    double worst = 0.0;
    for (int i = 0; i <= 100; ++i)
        worst = std::max(worst, (spline.point(track.uv(0.1 * i)) - track.target(0.1 * i)).norm());
    return worst;
}

}  // namespace

// What it meets within its tolerance only makes cuts of the written shape fail.
TEST(FaceSpline, MeetsCurvesWhoseKnotsItHasExactly)
{
    const SplineTargets targets = curve_along_the_border();
    SurfacePatch patch = square();
    FaceSpline without(patch);
    without.fit(targets, 1e-3, Progress());
    EXPECT_GT(largest_gap(without, targets.tracks[0]), 1e-5);
    patch.knots[0] = {{3.7, 3.7}};
    FaceSpline with(patch);
    with.fit(targets, 1e-3, Progress());
    EXPECT_LT(largest_gap(with, targets.tracks[0]), 1e-7);
}

// Beside a knot of its own, and of a curve with longer spans, it takes none.
TEST(FaceSpline, TakesNoKnotsThatMakeShortSpansOfLongOnes)
{
    SurfacePatch patch = square();
    patch.knots[1] = {{5.1, 0.1}, {2.5, 2.5}, {5.0, 2.5}, {7.5, 2.5}, {7.52, 0.1}};
    EXPECT_EQ(FaceSpline(patch).surface()->NbVKnots(), 6);
    EXPECT_EQ(FaceSpline(patch).surface()->NbUKnots(), 2);
}

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

}  // namespace sheetmorph::cad

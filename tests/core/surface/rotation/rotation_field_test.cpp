// SPDX-License-Identifier: LGPL-2.1-or-later
// What the rotation field promises under `neumann` and `natural`, on both kinds of triangles.
#include "sheetmorph/surface/rotation/rotation_field.h"

#include "shapes/variations.h"
#include "surface/strip.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;
using cases::solve;

struct Way
{
    Energy energy;
    Laplacian laplacian;
};

class RotationFields : public testing::TestWithParam<Way>
{
protected:
    // A strip held at x = 0, with handles at its middle and its tip that turn about x by degrees.
    static Case turned_strip(double middle, double tip)
    {
        Case one = cases::strip(24);
        one.constraints.energy = GetParam().energy;
        one.constraints.laplacian = GetParam().laplacian;
        one.constraints.handles.push_back(cases::region(
            "middle", one.mesh, [](const Vector3& p) { return std::abs(p.x() - 50.0) < 1e-6; }));
        one.targets.handles = {
            cases::motion(Vector3::Zero(), Vector3::UnitX(), tip, {100.0, 12.5, 0.0}),
            cases::motion(Vector3::Zero(), Vector3::UnitX(), middle, {50.0, 12.5, 0.0})};
        return one;
    }
};

TEST_P(RotationFields, DoNotOvershootBetweenTheirHandles)
{
    // 0, 1, 1 in a row, which the biharmonic field of `paper` takes to 1.29.
    const Points logs = solve(turned_strip(80.0, 80.0)).rotation_logs;
    const double most = 40.0 * shapes::pi / 180.0;
    EXPECT_GT(logs.col(0).minCoeff(), -1e-12);
    EXPECT_LT(logs.col(0).maxCoeff(), most + 1e-12);
    EXPECT_LT(logs.rightCols(2).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(RotationFields, GrowWithAHandleBeyondHalfATurnAndAWholeOne)
{
    // From 120 degrees on `natural` spreads a turn evenly (far_turns.h).
    const double first = GetParam().energy == Energy::natural ? 12.0 : 1.0;
    const Points small = solve(turned_strip(10.0 * first, 20.0 * first)).rotation_logs / first;
    for (const double times : {12.0, 18.0, 20.0, 40.0})
        EXPECT_LT((solve(turned_strip(10.0 * times, 20.0 * times)).rotation_logs - times * small)
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-9);
}

TEST_P(RotationFields, LeadFrom0To400DegreesWithoutALeap)
{
    Points last;
    for (int degrees = 0; degrees <= 400; degrees += 10)
    {
        const Case one = turned_strip(0.5 * degrees, degrees);
        const Points shape = solve(one).positions;
        if (degrees > 0)
            EXPECT_LT((shape - last).rowwise().norm().maxCoeff(), 0.05 * one.mesh.size());
        last = shape;
    }
}

TEST_P(RotationFields, TurnWithTheCoordinates)
{
    const Case one = turned_strip(60.0, 200.0);
    const RigidMotion view =
        cases::motion({30.0, -20.0, 50.0}, {0.3, -0.7, 0.4}, 77.0, {5.0, 8.0, -3.0});
    const Matrix3 rotation = view.rotation();
    Case seen = one;
    seen.mesh = shapes::moved(one.mesh, view);
    for (RigidMotion& handle : seen.targets.handles)
    {
        handle.pivot = view.apply(handle.pivot);
        handle.rotation_log = rotation * handle.rotation_log;
    }
    const Points expected = solve(one).rotation_logs * rotation.transpose();
    EXPECT_LT((solve(seen).rotation_logs - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(BiharmonicField, TellsThatItDidNotSettle)
{
    Case strip = cases::strip(24);
    strip.constraints.energy = Energy::paper;
    strip.targets.handles = {
        cases::motion(Vector3::Zero(), Vector3::UnitX(), 30.0, {100.0, 12.5, 0.0})};
    EXPECT_TRUE(solve(strip).convergence.is_converged);
    // A thread, a thousand times longer than wide: no digit is left of what refines it.
    strip.mesh = shapes::mapped(strip.mesh,
                                [](const Vector3& p) { return Vector3(p.x(), 1e-3 * p.y(), 0.0); });
    const Convergence lost = solve(strip).convergence;
    EXPECT_FALSE(lost.is_converged);
    EXPECT_GT(lost.rounds, 1);
    EXPECT_EQ(lost.sentence().find("the rotations of the sheet did not converge"), 0U);
}

INSTANTIATE_TEST_SUITE_P(Ways, RotationFields,
                         testing::Values(Way{Energy::neumann, Laplacian::cotangent},
                                         Way{Energy::natural, Laplacian::cotangent},
                                         Way{Energy::natural, Laplacian::intrinsic}));

}  // namespace
}  // namespace sheetmorph::surface

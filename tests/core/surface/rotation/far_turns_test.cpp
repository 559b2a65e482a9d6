// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole turns of a handle are kept, whatever the energy: the sheet follows them from angle to
// angle.
#include "sheetmorph/surface/rotation/far_turns.h"

#include "surface/free_strip.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;
using cases::degree;
using cases::solve;

constexpr int along = 60, across = 4;
constexpr double length = 300.0, width = 12.0;

// A slender strip that its tip twists by degrees.
Case twisted(Energy energy, double degrees, double height = 0.0)
{
    Case one{"twisted strip", shapes::grid(along, across, length, width), {}, {}};
    one.mesh = shapes::mapped(one.mesh, [&](const Vector3& p)
                              { return Vector3(p.x(), p.y(), height * std::sin(p.x() / 40.0)); });
    one.constraints.energy = energy;
    one.constraints.fixed = {
        cases::region("root", one.mesh, [](const Vector3& p) { return p.x() < 1e-6; })};
    one.constraints.handles = {
        cases::region("tip", one.mesh, [](const Vector3& p) { return p.x() > length - 1e-6; })};
    const double end = height * std::sin(length / 40.0);
    one.targets.handles = {
        cases::motion(Vector3::Zero(), Vector3::UnitX(), degrees, {length, 0.5 * width, end})};
    return one;
}

//! How a strip is twisted: the angle of its cross direction about x, unwrapped from the root, and
//! widths.
struct Twist
{
    std::vector<double> degrees, widths;

    explicit Twist(const Points& shape, const mesh::TriangleMesh& rest)
    {
        double last = 0.0;
        for (int i = 0; i <= along; ++i)
        {
            Vector3 low = Vector3::Zero(), high = low;
            for (int k = 0; k < rest.vertex_count(); ++k)
                if (std::abs(rest.points()(k, 0) - i * length / along) < 1e-6)
                {
                    if (rest.points()(k, 1) < 1e-6)
                        low = shape.row(k).transpose();
                    if (rest.points()(k, 1) > width - 1e-6)
                        high = shape.row(k).transpose();
                }
            const Vector3 cross = high - low;
            const double angle = std::atan2(cross.z(), cross.y()) / degree;
            last += std::remainder(angle - last, 360.0);
            degrees.push_back(last);
            widths.push_back(cross.norm());
        }
    }

    double narrowest() const { return *std::min_element(widths.begin(), widths.end()); }
};

class FarTurnsOf : public testing::TestWithParam<Energy>
{
};

TEST_P(FarTurnsOf, FollowTheHandleInSmallStepsThroughThreeWholeTurns)
{
    double before = 0.0;
    for (double angle = 0.0; angle <= 1080.0; angle += 15.0)
    {
        const Case one = twisted(GetParam(), angle);
        const Twist run(solve(one).positions, one.mesh);
        EXPECT_NEAR(run.degrees.back(), angle, 1e-6);
        const double middle = run.degrees[along / 2];
        EXPECT_NEAR(middle, 0.5 * angle, 1.0);
        // As a sequence of small steps goes: no step back, none that leaps.
        EXPECT_GE(middle, before);
        EXPECT_LT(middle - before, 15.0);
        before = middle;
    }
}

TEST_P(FarTurnsOf, LeadTheOtherWayToTheMirrorImage)
{
    for (const double angle : {190.0, 360.0, 725.0})
    {
        const Case one = twisted(GetParam(), angle), other = twisted(GetParam(), -angle);
        Points mirrored = solve(other).positions;
        mirrored.col(2) *= -1.0;
        EXPECT_LT((mirrored - solve(one).positions).cwiseAbs().maxCoeff(), 1e-9 * length);
    }
}

TEST_P(FarTurnsOf, OfEverythingAtOnceMoveItRigidly)
{
    Case one = twisted(GetParam(), 400.0, 10.0);
    one.constraints.handles.push_back(one.constraints.fixed[0]);
    one.constraints.fixed.clear();
    one.targets.handles.push_back(one.targets.handles[0]);
    const Points expected = one.targets.handles[0].apply(one.mesh.points());
    EXPECT_LT((solve(one).positions - expected).cwiseAbs().maxCoeff(), 1e-9 * length);
}

INSTANTIATE_TEST_SUITE_P(Energies, FarTurnsOf,
                         testing::Values(Energy::paper, Energy::neumann, Energy::natural));

TEST(FarTurns, LeaveNaturalItsWidth)
{
    for (double angle = 0.0; angle <= 1080.0; angle += 15.0)
    {
        const Case one = twisted(Energy::natural, angle);
        EXPECT_GT(Twist(solve(one).positions, one.mesh).narrowest(), 0.8 * width) << angle;
    }
}

TEST(FarTurns, ChangeNothingUpTo60Degrees)
{
    const Case one = twisted(Energy::natural, 60.0), other = twisted(Energy::natural, -60.0);
    // Linear: the mean of both turns is a shape that no turn bends.
    const Points mean = 0.5 * (solve(one).positions + solve(other).positions);
    EXPECT_LT(mean.col(2).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(Twist(solve(one).positions, one.mesh).widths[along / 2],
                width * std::cos(30.0 * degree), 0.01 * width);
}

TEST(FarTurns, GrowWithoutALeapOnACurvedSheetWithFreeHoles)
{
    Case one = cases::strip_with_holes(true);
    one.constraints.energy = Energy::natural;
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    Points last = one.mesh.points();
    for (double angle = 15.0; angle <= 720.0; angle += 15.0)
    {
        one.targets.handles = {
            cases::motion(Vector3::Zero(), Vector3::UnitX(), angle, {300.0, 50.0, 0.0})};
        const Deformation found = deformer.deform(one.targets);
        EXPECT_TRUE(found.convergence.is_converged) << angle;
        EXPECT_LT((found.positions - last).rowwise().norm().maxCoeff(), 25.0) << angle;
        last = found.positions;
    }
}

TEST(FarTurns, RollAStripUpToACircle)
{
    // The tip turns about the axis across the strip and moves as the end of an arc does.
    Case one = twisted(Energy::natural, 0.0);
    const SurfaceDeformer deformer(one.mesh, one.constraints);
    for (const double turn : {30.0, 60.0, 90.0, 120.0, 180.0, 300.0})
    {
        const double angle = turn * degree, radius = length / angle;
        one.targets.handles = {cases::motion(
            {radius * std::sin(angle) - length, 0.0, radius * (1.0 - std::cos(angle))},
            -Vector3::UnitY(), turn, {length, 0.0, 0.0})};
        const Points shape = deformer.deform(one.targets).positions;
        for (int k = 0; k < one.mesh.vertex_count(); ++k)
        {
            const Vector3 rest = one.mesh.points().row(k).transpose();
            const double along_arc = rest.x() / radius;
            const Vector3 expected(radius * std::sin(along_arc), rest.y(),
                                   radius * (1.0 - std::cos(along_arc)));
            EXPECT_LT((shape.row(k).transpose() - expected).norm(), 0.03 * length) << turn;
        }
    }
}

}  // namespace
}  // namespace sheetmorph::surface

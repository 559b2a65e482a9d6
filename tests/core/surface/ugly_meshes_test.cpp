// SPDX-License-Identifier: LGPL-2.1-or-later
// Real decks: slivers, T-junctions, sheets that meet; the answer is as good as on a clean mesh.
#include "shapes/ugly.h"
#include "surface/analytic.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;
using cases::solve;

// Error of the clamped strip on a mesh with slivers, relative to the lift.
double ugly_strip_error(Energy energy, Laplacian laplacian, double sliver)
{
    Case one = cases::lifted_strip(energy, 32, false);
    one.mesh = shapes::with_slivers(one.mesh, 7, sliver);
    one.constraints.laplacian = laplacian;
    return 0.1
           * cases::worst_height_error(one, solve(one).positions,
                                       [](const Eigen::RowVector3d& p)
                                       {
                                           const double s = p.x() / 100.0;
                                           return 10.0 * s * s * (3.0 - 2.0 * s);
                                       });
}

TEST(UglyMeshes, SliversAndTJunctionsDoNotHurtNatural)
{
    const double clean = cases::clamped_strip_error(Energy::natural, 32, false);
    for (const double sliver : {1e-2, 1e-4, 1e-8, 0.0})
        for (const Laplacian laplacian : {Laplacian::cotangent, Laplacian::intrinsic})
            EXPECT_LT(ugly_strip_error(Energy::natural, laplacian, sliver), 1.5 * clean) << sliver;
}

TEST(UglyMeshes, IntrinsicTrianglesCureSliversUnderNeumann)
{
    for (const double sliver : {1e-2, 1e-4, 1e-8, 0.0})
    {
        const double cured = ugly_strip_error(Energy::neumann, Laplacian::intrinsic, sliver);
        EXPECT_LT(cured, 5e-3) << sliver;
        EXPECT_LT(cured, ugly_strip_error(Energy::neumann, Laplacian::cotangent, sliver)) << sliver;
    }
}

TEST(UglyMeshes, ThreeSheetsThatMeetInAnEdgeBendTogether)
{
    // The foot of the T is held, one arm lifted: the other arm and the stem's joint follow.
    for (const Laplacian laplacian : {Laplacian::cotangent, Laplacian::intrinsic})
        for (const Energy energy : {Energy::neumann, Energy::natural})
        {
            Case one{"t", shapes::with_slivers(shapes::t_joint(8, 40.0), 6, 1e-5), {}, {}};
            one.constraints.energy = energy;
            one.constraints.laplacian = laplacian;
            one.constraints.fixed = {
                cases::region("root", one.mesh, [](const Vector3& p) { return p.z() > 39.0; })};
            one.constraints.handles = {
                cases::region("tip", one.mesh, [](const Vector3& p) { return p.y() > 39.0; })};
            one.targets.handles = {{{0.0, 0.0, 5.0}, Vector3::Zero(), Vector3::Zero()}};
            const Points moved = solve(one).positions - one.mesh.points();
            EXPECT_TRUE(moved.allFinite());
            EXPECT_LT(moved.cwiseAbs().maxCoeff(), 10.0);
            const RigidMotion turn =
                cases::motion({5.0, 6.0, 7.0}, {0.0, 1.0, 1.0}, 100.0, Vector3::Zero());
            one.constraints.fixed.clear();
            one.targets.handles = {turn};
            EXPECT_LT((solve(one).positions - turn.apply(one.mesh.points())).norm(), 1e-7);
        }
}

}  // namespace
}  // namespace sheetmorph::surface

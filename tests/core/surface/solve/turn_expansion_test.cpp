// SPDX-License-Identifier: LGPL-2.1-or-later
// Products with the second derivative of the energy beside the derivative itself.
#include "sheetmorph/surface/features/reduced_expansion.h"
#include "sheetmorph/surface/solve/pose_steps.h"
#include "surface/free_strip.h"

#include <gmock/gmock.h>

namespace sheetmorph::surface
{
namespace
{

using namespace cases;

//! What is the same of both, of a strip with holes whose handle is moved and turned.
struct Compared
{
    double stiffness, gradients, hessians;  // the largest entry, and by how much they differ
    double solved;                          // how far solving it as it is at rest is off, of 1
};

Compared compared(const Joints& joints, const Measure& measure)
{
    EXPECT_TRUE(TurnExpansion::is_possible(joints, measure.responses));
    const Forces forces = forces_at(joints, measure);
    const Expansion whole = expand(joints, measure, forces);
    const TurnExpansion quick(joints, measure, forces);
    const Eigen::Index count = joints.freedoms();
    const Eigen::MatrixXd units = Eigen::MatrixXd::Identity(count, count);
    Eigen::MatrixXd products(count, count), solved(count, count);
    for (Eigen::Index k = 0; k < count; ++k)
    {
        products.col(k) = quick.times(units.col(k));
        solved.col(k) = quick.nearly_solved(products.col(k));
    }
    return {whole.hessian.cwiseAbs().maxCoeff(),
            (quick.gradient() - whole.gradient).cwiseAbs().maxCoeff(),
            (products - whole.hessian).cwiseAbs().maxCoeff(),
            (solved - units).cwiseAbs().maxCoeff()};
}

class TurnExpansions : public testing::TestWithParam<double>
{
};

TEST_P(TurnExpansions, GiveTheProductsOfTheSecondDerivative)
{
    Case one = strip_with_holes(true);
    one.targets.handles = {
        cases::motion({5.0, 3.0, 20.0}, {1.0, 0.4, 0.2}, GetParam(), {300.0, 50.0, 0.0})};
    const PreparedSurface part(one.mesh, one.constraints, {}, nullptr);
    const PlacementInput placement = part.placement();
    BodyMotions bodies = known_body_motions(placement, one.targets);
    const Field field = field_of(part, given_rotations(placement, one.targets, bodies));
    turn_open_bodies(placement, field.logs, field.tilts, bodies);
    numerics::ConstrainedMinimiser::Targets asked;
    asked.constraints.resize(0, 3);
    const Turned turned = turned_features(part, {one.targets, bodies, field}, asked);
    const Joints start(placement, one.targets, part.responses->turners(), bodies);
    const Measure measure{placement, *part.responses, turned.energy};
    for (const Joints* joints : {&start, &turned.joints})
    {
        const Compared found = compared(*joints, measure);
        EXPECT_LT(found.gradients, 1e-12 * found.stiffness);
        EXPECT_LT(found.hessians, 1e-12 * found.stiffness);
    }
    EXPECT_TRUE(turned.convergence.is_converged);
}

INSTANTIATE_TEST_SUITE_P(Degrees, TurnExpansions, testing::Values(0.0, 40.0, 120.0));

TEST(TurnedWhole, IsSolvedExactlyAsAtRest)
{
    for (const double degrees : {0.0, 50.0})
    {
        Case one = strip_with_holes(true);
        const Vector3 log = rotation_log({1.0, 0.4, 0.2}, degrees * degree);
        one.targets.handles = {RigidMotion{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()}};
        const PreparedSurface part(one.mesh, one.constraints, {}, nullptr);
        const PlacementInput placement = part.placement();
        BodyMotions bodies = known_body_motions(placement, one.targets);
        for (RigidMotion& motion : bodies.motions)
            motion.rotation_log = log;
        const Joints joints(placement, one.targets, part.responses->turners(), bodies);
        // The slope under which this is the minimum: what is pulled back is what was turned.
        ReducedEnergy energy{part.responses->stiffness(), {}};
        energy.slope = -energy.stiffness * entries_of(joints, placement, *part.responses);
        const Compared found = compared(joints, {placement, *part.responses, energy});
        EXPECT_LT(found.solved, 1e-9) << degrees;
    }
}

}  // namespace
}  // namespace sheetmorph::surface

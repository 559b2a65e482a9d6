// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/joints.h"

#include "sheetmorph/surface/bodies/vertex_roles.h"
#include "surface/free_strip.h"

#include <gtest/gtest.h>

namespace sheetmorph::surface
{
namespace
{

using cases::Case;

// A strip with a free hole, one that shifts in a plane and one that turns about an axis.
Case with_motions()
{
    Case one = cases::strip_with_holes();
    one.constraints.features[1].motion = {FeatureMotion::Type::plane, Vector3::Zero(),
                                          Vector3(1, 2, 2) / 3.0};
    one.constraints.features[2].motion = {
        FeatureMotion::Type::axis, {250.0, 40.0, 10.0}, Vector3::UnitY()};
    return one;
}

struct Moves
{
    int turns = 0, shifts = 0;
};

// Where the bodies are after one freedom moved by an amount: an angle in radians, or mm.
std::vector<BodyState> moved(const Joints& joints, int freedom, double amount, Moves& moves)
{
    std::vector<BodyState> states = joints.states();
    for (std::size_t k = 0; k < states.size(); ++k)
        for (const JointLevel& level : joints.levels(k))
        {
            const int axis = freedom - level.first;
            if (axis < 0 || axis >= static_cast<int>(level.axes.size()))
                continue;
            const Vector3& along = level.axes[static_cast<std::size_t>(axis)];
            EXPECT_NEAR(along.norm(), 1.0, 1e-12);
            BodyState& state = states[k];
            (level.is_turn ? moves.turns : moves.shifts) += 1;
            if (!level.is_turn)
            {
                state.centre += amount * along;
                continue;
            }
            const Matrix3 turn = Eigen::AngleAxisd(amount, along).matrix();
            state.rotation = turn * state.rotation;
            state.centre = level.point + turn * (state.centre - level.point);
        }
    return states;
}

// The derivatives of the reduced problem are those by these angles and lengths.
TEST(Joints, AStepTurnsByItsAnglesAndShiftsByItsLengths)
{
    const Case one = with_motions();
    const VertexRoles roles = assign_roles(one.mesh, one.constraints);
    const PlacementInput part{one.mesh, one.constraints, roles};
    const std::vector<Turner> turners = turners_of(one.mesh, one.constraints, roles);
    ASSERT_EQ(turners.size(), 3u);
    const BodyMotions known = known_body_motions(part, one.targets);
    Joints joints(part, one.targets, turners, known);
    const std::vector<BodyState> before = joints.states();
    Moves moves;
    for (const double amount : {0.3, -0.2})
        for (int freedom = 0; freedom < joints.freedoms(); ++freedom)
        {
            const std::vector<BodyState> expected = moved(joints, freedom, amount, moves);
            joints.step(amount * Eigen::VectorXd::Unit(joints.freedoms(), freedom));
            for (std::size_t k = 0; k < turners.size(); ++k)
            {
                EXPECT_LT((joints.states()[k].rotation - expected[k].rotation).norm(), 1e-12);
                EXPECT_LT((joints.states()[k].centre - expected[k].centre).norm(), 1e-10);
            }
            joints.restore(before);
        }
    EXPECT_EQ(moves.turns, 2 * (3 + 1 + 1));
    EXPECT_EQ(moves.shifts, 2 * 2);
}

}  // namespace
}  // namespace sheetmorph::surface

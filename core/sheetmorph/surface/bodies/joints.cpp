// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/joints.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/bodies/allowed_motion.h"

#include <Eigen/Geometry>

namespace sheetmorph::surface
{

namespace
{

constexpr int none = -1;

std::vector<Vector3> every_axis()
{
    return {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
}

std::vector<Vector3> axes_across(const Vector3& direction)
{
    const Vector3 first = direction.unitOrthogonal();
    return {first, direction.cross(first)};
}

BodyState state_of_motion(const Body& body, const RigidMotion& motion)
{
    return {motion.rotation(), motion.apply(body.centre)};
}

JointLevel turn(const Vector3& point, std::vector<Vector3> axes)
{
    return {true, point, std::move(axes), 0};
}

JointLevel shift(std::vector<Vector3> axes)
{
    return {false, Vector3::Zero(), std::move(axes), 0};
}

// Possible motions of a body with a FeatureMotion, from its current state.
std::vector<JointLevel> restricted_levels(const PlacementInput& part, const Body& body,
                                          const BodyState& state)
{
    const bool turns = body.motion == Body::Motion::free;
    const FormFeature& feature = part.constraints.features[at(body.restricted)];
    const Vector3 centre = moved_point(body, state, centre_of(part.rest, feature.vertices));
    const Vector3& along = feature.motion.direction;
    std::vector<JointLevel> levels;
    if (feature.motion.type == FeatureMotion::Type::axis)
    {
        if (turns)
            levels.push_back(turn(feature.motion.point, {along}));
        return levels;
    }
    const bool is_plane = feature.motion.type == FeatureMotion::Type::plane;
    levels.push_back(shift(is_plane ? axes_across(along) : std::vector<Vector3>{along}));
    if (turns)
        levels.push_back(turn(centre, is_plane ? std::vector<Vector3>{along} : every_axis()));
    return levels;
}

// Possible motions of a body that follows a link, from its current state, relative to its leader.
std::vector<JointLevel> following_levels(const PlacementInput& part, const Body& body,
                                         const BodyState& leader, const BodyState& state)
{
    const FeatureLink& link = part.constraints.links[at(body.following->link)];
    if (link.type == FeatureLinkType::coaxial)
    {
        const Vector3 axis = leader.rotation * link.direction;
        return {shift({axis}), turn(leader.centre, {axis})};
    }
    const VertexIds& vertices = part.constraints.features[at(body.following->feature)].vertices;
    const Vector3 centre = moved_point(body, state, centre_of(part.rest, vertices));
    const Vector3 arm = centre - leader.centre;
    std::vector<JointLevel> levels;
    if (arm.norm() > 0.0)
        levels.push_back(turn(leader.centre, axes_across(arm.normalized())));
    levels.push_back(turn(centre, every_axis()));
    return levels;
}

// Applies the unknowns of a level to a state.
void move(BodyState& state, const JointLevel& level, const Eigen::VectorXd& q)
{
    Vector3 amount = Vector3::Zero();
    for (std::size_t k = 0; k < level.axes.size(); ++k)
        amount += q(level.first + static_cast<Eigen::Index>(k)) * level.axes[k];
    if (!level.is_turn)
    {
        state.centre += amount;
        return;
    }
    const Matrix3 rotation = rotation_from_log(0.5 * amount);
    state.rotation = rotation * state.rotation;
    state.centre = level.point + rotation * (state.centre - level.point);
}

}  // namespace

Joints::Joints(const PlacementInput& part, const SurfaceTargets& targets,
               const std::vector<Turner>& turners, const BodyMotions& bodies)
    : part_(part),
      targets_(targets),
      turners_(turners),
      known_(bodies),
      turner_of_body_(part.roles.bodies.size(), none),
      states_(turners.size())
{
    for (std::size_t k = 0; k < turners.size(); ++k)
    {
        if (turners[k].body >= 0)
            turner_of_body_[at(turners[k].body)] = static_cast<int>(k);
        place_at_start(bodies, k);
    }
    renew_levels();
}

BodyState Joints::state_of_body(int body) const
{
    const int turner = turner_of_body_[at(body)];
    return turner != none ? states_[at(turner)]
                          : state_of_motion(part_.roles.bodies[at(body)], known_.motions[at(body)]);
}

// The leading body's rotation and the deformed centre of its feature.
BodyState Joints::leader_of(const Body& body) const
{
    const Following& following = *body.following;
    if (following.leader < 0)
    {
        const RigidMotion& motion = targets_.leaders[at(following.link)];
        return {motion.rotation(), motion.apply(following.centre)};
    }
    const BodyState state = state_of_body(following.leader);
    return {state.rotation,
            moved_point(part_.roles.bodies[at(following.leader)], state, following.centre)};
}

void Joints::place_at_start(const BodyMotions& bodies, std::size_t k)
{
    const Turner& turner = turners_[k];
    if (turner.body < 0)
    {
        const int corner = turner.vertices.front();
        states_[k] = {Matrix3::Identity(), part_.rest.points().row(corner).transpose()};
        return;
    }
    const Body& body = part_.roles.bodies[at(turner.body)];
    BodyState start = state_of_motion(body, bodies.motions[at(turner.body)]);
    if (body.handle >= 0)
    {
        const RigidMotion& motion = targets_.handles[at(body.handle)];
        start.centre =
            motion.pivot + motion.translation + start.rotation * (body.centre - motion.pivot);
    }
    else if (body.restricted >= 0)
        start = nearest_restricted(part_, body, start);
    else if (body.following)
        start = carried_along(body, leader_of(body));
    states_[k] = start;
}

std::vector<JointLevel> Joints::own_levels(std::size_t k) const
{
    const Turner& turner = turners_[k];
    const BodyState& state = states_[k];
    if (turner.body < 0)
        return {turn(state.centre, every_axis())};
    const Body& body = part_.roles.bodies[at(turner.body)];
    if (body.handle >= 0)
    {
        const RigidMotion& motion = targets_.handles[at(body.handle)];
        if (!turner.turns)
            return {};
        return {turn(motion.pivot + motion.translation, every_axis())};
    }
    if (body.restricted >= 0)
        return restricted_levels(part_, body, state);
    if (body.following)
        return following_levels(part_, body, leader_of(body), state);
    std::vector<JointLevel> levels;
    if (turner.is_bound || turner.shifts)
        levels.push_back(shift(every_axis()));
    if (turner.turns)
        levels.push_back(turn(state.centre, every_axis()));
    return levels;
}

void Joints::renew_levels()
{
    levels_.assign(turners_.size(), {});
    freedoms_ = 0;
    for (std::size_t k = 0; k < turners_.size(); ++k)
    {
        if (turners_[k].body >= 0 && part_.roles.bodies[at(turners_[k].body)].following)
        {
            const int leader = part_.roles.bodies[at(turners_[k].body)].following->leader;
            if (leader >= 0 && turner_of_body_[at(leader)] != none)
                levels_[k] = levels_[at(turner_of_body_[at(leader)])];
        }
        for (JointLevel& level : own_levels(k))
        {
            level.first = freedoms_;
            freedoms_ += static_cast<int>(level.axes.size());
            levels_[k].push_back(std::move(level));
        }
    }
}

void Joints::restore(const std::vector<BodyState>& states)
{
    states_ = states;
    renew_levels();
}

void Joints::start_as_known()
{
    for (std::size_t k = 0; k < turners_.size(); ++k)
        if (const int body = turners_[k].body; body >= 0)
            states_[k] = state_of_motion(part_.roles.bodies[at(body)], known_.motions[at(body)]);
    renew_levels();
}

void Joints::step(const Eigen::VectorXd& q)
{
    for (std::size_t k = 0; k < turners_.size(); ++k)
        for (std::size_t level = levels_[k].size(); level-- > 0;)
            move(states_[k], levels_[k][level], q);
    renew_levels();
}

}  // namespace sheetmorph::surface

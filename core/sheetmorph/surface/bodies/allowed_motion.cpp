// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/allowed_motion.h"

#include "sheetmorph/base/index.h"

#include <Eigen/Geometry>

namespace sheetmorph::surface
{

namespace
{

// The state of a body with a given rotation that maps the rest point `from` to `to`.
BodyState placed(const Body& body, const Matrix3& rotation, const Vector3& from, const Vector3& to)
{
    return {rotation, to + rotation * (body.centre - from)};
}

const FormFeature& feature_of(const PlacementInput& part, int feature)
{
    return part.constraints.features[at(feature)];
}

}  // namespace

Matrix3 twist_about(const Matrix3& rotation, const Vector3& axis)
{
    const Eigen::Quaterniond turn(rotation);
    const double along = turn.vec().dot(axis);
    const double length = std::hypot(turn.w(), along);
    // From rounding: a shorter direction is none.
    if (length < 1e-12)
        return Matrix3::Identity();
    Eigen::Quaterniond twist;
    twist.w() = turn.w() / length;
    twist.vec() = (along / length) * axis;
    return twist.toRotationMatrix();
}

Vector3 moved_point(const Body& body, const BodyState& state, const Vector3& point)
{
    return state.centre + state.rotation * (point - body.centre);
}

BodyState nearest_restricted(const PlacementInput& part, const Body& body, const BodyState& wanted)
{
    const FormFeature& feature = feature_of(part, body.restricted);
    const Vector3 centre = centre_of(part.rest, feature.vertices);
    const Vector3 shift = moved_point(body, wanted, centre) - centre;
    const Vector3& along = feature.motion.direction;
    const bool turns_as_told = body.motion == Body::Motion::prescribed;
    switch (feature.motion.type)
    {
        case FeatureMotion::Type::plane:
        {
            const bool is_field = body.motion == Body::Motion::interpolated || turns_as_told;
            const Matrix3 rotation =
                is_field ? wanted.rotation : twist_about(wanted.rotation, along);
            return placed(body, rotation, centre, centre + shift - along.dot(shift) * along);
        }
        case FeatureMotion::Type::line:
            return placed(body, wanted.rotation, centre, centre + along.dot(shift) * along);
        case FeatureMotion::Type::axis:
            return placed(body, twist_about(wanted.rotation, along), feature.motion.point,
                          feature.motion.point);
        default:
            return wanted;
    }
}

BodyState carried_along(const Body& body, const BodyState& leader)
{
    return {leader.rotation,
            leader.centre + leader.rotation * (body.centre - body.following->centre)};
}

BodyState nearest_following(const PlacementInput& part, const Body& body, const BodyState& leader,
                            const BodyState& wanted)
{
    const FeatureLink& link = part.constraints.links[at(body.following->link)];
    const Vector3 centre = centre_of(part.rest, feature_of(part, body.following->feature).vertices);
    if (link.type == FeatureLinkType::distance)
    {
        const Vector3 arm = centre - body.following->centre;
        const Vector3 wanted_arm = moved_point(body, wanted, centre) - leader.centre;
        const double length = wanted_arm.norm();
        const Vector3 direction = length > 0.0 ? Vector3(wanted_arm / length)
                                               : Vector3(leader.rotation * arm.normalized());
        return placed(body, wanted.rotation, centre, leader.centre + arm.norm() * direction);
    }
    const Vector3 axis = leader.rotation * link.direction;
    const BodyState start = carried_along(body, leader);
    const Matrix3 spin = twist_about(wanted.rotation * leader.rotation.transpose(), axis);
    const double slide = axis.dot(wanted.centre - start.centre);
    return {spin * leader.rotation,
            leader.centre + spin * (start.centre - leader.centre) + slide * axis};
}

}  // namespace sheetmorph::surface

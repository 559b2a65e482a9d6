// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/body_motions.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/bodies/allowed_motion.h"
#include "sheetmorph/surface/bodies/clamping.h"

#include <Eigen/Geometry>

namespace sheetmorph::surface
{

namespace
{

// The same motion, expressed about the body's centre.
RigidMotion about(const Vector3& centre, const RigidMotion& motion)
{
    RigidMotion moved = motion;
    moved.pivot = centre;
    moved.translation = motion.apply(centre) - centre;
    return moved;
}

Matrix3 rotation_at(const PropagatedTarget& target, std::size_t k)
{
    return target.rotations.empty()
               ? rotation_from_log(target.rotation_logs.row(static_cast<Eigen::Index>(k)))
               : target.rotations[k];
}

// The motion with a given rotation that maps the carriers' centroid to that of their targets.
RigidMotion carried_with_rotation(const Carriers& carriers, const Vector3& centre,
                                  const Vector3& rotation_log)
{
    RigidMotion motion;
    motion.pivot = centre;
    motion.rotation_log = rotation_log;
    const Vector3 start = carriers.rest.colwise().mean().transpose();
    motion.translation = carriers.targets.colwise().mean().transpose() - motion.apply(start);
    return motion;
}

// The best rigid motion of the carriers. Rotations that the carriers do not determine (one vertex,
// a straight row) follow their mean rotation.
RigidMotion carried_motion(const Carriers& carriers, const Vector3& centre)
{
    Matrix3 sum = Matrix3::Zero();
    for (const Matrix3& rotation : carriers.rotations)
        sum += rotation;
    const Vector3 mean_log = carriers.logs.colwise().mean().transpose();
    const Vector3 turn = nearest_branch(log_from_rotation(nearest_rotation(sum)), mean_log);
    return about(centre, best_rigid_motion_near(carriers.rest, carriers.targets, turn));
}

void add_propagated(const PlacementInput& part, const SurfaceTargets& targets,
                    GivenRotations& given)
{
    const auto count = static_cast<Eigen::Index>(targets.propagated.size());
    given.logs.regions = Points::Zero(count, 3);
    given.tilts.regions = Points::Zero(count, 3);
    for (Eigen::Index region = 0; region < count; ++region)
    {
        const PropagatedTarget& target = targets.propagated[static_cast<std::size_t>(region)];
        const VertexIds& vertices =
            part.constraints.propagated[static_cast<std::size_t>(region)].vertices;
        given.logs.regions.row(region) = target.rotation_logs.colwise().mean();
        for (std::size_t k = 0; k < vertices.size(); ++k)
        {
            const Vector3 log = target.rotation_logs.row(static_cast<Eigen::Index>(k)).transpose();
            const Vector3 tilt = target.rotations.empty() ? Vector3(Vector3::Zero())
                                                          : tilt_beyond(target.rotations[k], log);
            given.tilts.regions.row(region) +=
                tilt.transpose() / static_cast<double>(vertices.size());
            if (part.roles.role[at(vertices[k])] != Role::propagated)
                continue;
            given.logs.vertices.row(vertices[k]) = log.transpose();
            given.tilts.vertices.row(vertices[k]) = tilt.transpose();
        }
    }
}

// The prescribed rotation of a body as a log; zero if its feature only translates.
Vector3 told_rotation(const PlacementInput& part, const SurfaceTargets& targets, const Body& body)
{
    const FormFeature& feature = part.constraints.features[at(body.driver)];
    if (feature.rotation != FeatureRotation::prescribed)
        return Vector3::Zero();
    const Vector3& log = targets.feature_logs[at(body.driver)];
    const bool turns_about_axis =
        body.restricted >= 0
        && part.constraints.features[at(body.restricted)].motion.type == FeatureMotion::Type::axis;
    if (turns_about_axis)
    {
        const Vector3& axis = part.constraints.features[at(body.restricted)].motion.direction;
        // From the accuracy of 1e-9: the rotation is about the axis.
        if (log.cross(axis).norm() > 1e-9 * (1.0 + log.norm()))
            throw InvalidInput(feature.label()
                               + " turns about its axis only, but the pose prescribes a rotation "
                                 "about another one", "change the rotation or the motion");
    }
    return log;
}

// The motion of a body carried by propagated vertices, within the limits of its own motion or link.
RigidMotion carried_body(const PlacementInput& part, const SurfaceTargets& targets,
                         const Carriers& carriers, const BodyMotions& earlier)
{
    const Body& body = part.roles.bodies[at(carriers.body)];
    const RigidMotion best =
        body.driver < 0
            ? carried_motion(carriers, body.centre)
            : carried_with_rotation(carriers, body.centre, told_rotation(part, targets, body));
    const BodyState wanted{best.rotation(), best.apply(body.centre)};
    if (body.restricted >= 0)
        return motion_of(body, nearest_restricted(part, body, wanted), best.rotation_log);
    if (!body.following)
        return best;
    const Following& following = *body.following;
    const RigidMotion& leading = following.leader < 0 ? targets.leaders[at(following.link)]
                                                      : earlier.motions[at(following.leader)];
    const BodyState leader{leading.rotation(), leading.apply(following.centre)};
    return motion_of(body, nearest_following(part, body, leader, wanted), best.rotation_log);
}

}  // namespace

Carriers carriers_of(const PlacementInput& part, int body, const SurfaceTargets& targets)
{
    const std::vector<KnownRegion>& regions = part.constraints.propagated;
    Carriers carriers;
    carriers.body = body;
    auto& found = carriers.places;
    for (std::size_t region = 0; region < regions.size(); ++region)
    {
        const VertexIds& vertices = regions[region].vertices;
        for (std::size_t k = 0; k < vertices.size(); ++k)
            if (part.roles.role[at(vertices[k])] == Role::body
                && part.roles.owner[at(vertices[k])] == body)
                found.emplace_back(region, k);
    }
    const auto count = static_cast<Eigen::Index>(found.size());
    carriers.rest = carriers.targets = carriers.logs = Points(count, 3);
    for (Eigen::Index row = 0; row < count; ++row)
    {
        const auto [region, k] = found[static_cast<std::size_t>(row)];
        const auto source = static_cast<Eigen::Index>(k);
        carriers.rest.row(row) = part.rest.points().row(regions[region].vertices[k]);
        carriers.targets.row(row) = targets.propagated[region].positions.row(source);
        carriers.logs.row(row) = targets.propagated[region].rotation_logs.row(source);
        carriers.rotations.push_back(rotation_at(targets.propagated[region], k));
    }
    return carriers;
}

RigidMotion motion_of(const Body& body, const BodyState& state, const Vector3& reference)
{
    RigidMotion motion;
    motion.pivot = body.centre;
    motion.rotation_log = nearest_branch(log_from_rotation(state.rotation), reference);
    motion.translation = state.centre - body.centre;
    return motion;
}

BodyMotions known_body_motions(const PlacementInput& part, const SurfaceTargets& targets)
{
    const std::vector<Body>& bodies = part.roles.bodies;
    const auto count = static_cast<Eigen::Index>(bodies.size());
    BodyMotions known{std::vector<RigidMotion>(bodies.size()), Points::Zero(count, 3),
                      Points::Zero(count, 3)};
    for (const int index : leaders_first(bodies))
    {
        const Body& body = bodies[at(index)];
        RigidMotion& motion = known.motions[at(index)];
        motion.pivot = body.centre;
        Vector3 tilt = Vector3::Zero();
        if (body.motion == Body::Motion::handle)
            motion = about(body.centre, targets.handles[at(body.driver)]);
        else if (body.motion == Body::Motion::prescribed)
            motion.rotation_log = told_rotation(part, targets, body);
        Vector3 log = motion.rotation_log;
        if (body.motion == Body::Motion::propagated)
        {
            const Carriers carriers = carriers_of(part, index, targets);
            motion = carried_body(part, targets, carriers, known);
            log = body.driver < 0
                      ? log_near(motion.rotation(), carriers.logs.colwise().mean().transpose())
                      : motion.rotation_log;
            tilt = tilt_beyond(motion.rotation(), log);
        }
        known.logs.row(index) = log.transpose();
        known.tilts.row(index) = tilt.transpose();
    }
    return known;
}

GivenRotations given_rotations(const PlacementInput& part, const SurfaceTargets& targets,
                               const BodyMotions& bodies)
{
    GivenRotations given;
    KnownRotations& logs = given.logs;
    logs.bodies = bodies.logs;
    given.tilts.bodies = bodies.tilts;
    logs.handles.resize(static_cast<Eigen::Index>(targets.handles.size()), 3);
    for (std::size_t k = 0; k < targets.handles.size(); ++k)
        logs.handles.row(static_cast<Eigen::Index>(k)) =
            targets.handles[k].rotation_log.transpose();
    logs.points.resize(static_cast<Eigen::Index>(targets.points.size()), 3);
    for (std::size_t k = 0; k < targets.points.size(); ++k)
        logs.points.row(static_cast<Eigen::Index>(k)) = targets.points[k].rotation_log.transpose();
    given.tilts.handles = Points::Zero(logs.handles.rows(), 3);
    given.tilts.points = Points::Zero(logs.points.rows(), 3);
    logs.vertices = Points::Zero(part.rest.vertex_count(), 3);
    given.tilts.vertices = logs.vertices;
    for (int i = 0; i < part.rest.vertex_count(); ++i)
    {
        const int owner = part.roles.owner[at(i)];
        if (part.roles.role[at(i)] == Role::handle)
            logs.vertices.row(i) = logs.handles.row(owner);
        else if (part.roles.role[at(i)] == Role::body)
        {
            logs.vertices.row(i) = bodies.logs.row(owner);
            given.tilts.vertices.row(i) = bodies.tilts.row(owner);
        }
    }
    add_propagated(part, targets, given);
    turn_clamped(part.roles, given.logs);
    turn_clamped(part.roles, given.tilts);
    given.is_tilted = !given.tilts.vertices.isZero(0.0);
    return given;
}

void turn_open_bodies(const PlacementInput& part, const Points& logs, const Points& tilts,
                      BodyMotions& bodies)
{
    for (std::size_t k = 0; k < part.roles.bodies.size(); ++k)
    {
        if (part.roles.bodies[k].is_known())
            continue;
        const int first = part.roles.bodies[k].vertices.front();
        const Vector3 log = logs.row(first).transpose();
        const Vector3 tilt = tilts.row(first).transpose();
        bodies.motions[k].rotation_log =
            tilt.isZero(0.0) ? log
                             : nearest_branch(log_from_rotation(tilted_rotation(log, tilt)), log);
    }
}

}  // namespace sheetmorph::surface

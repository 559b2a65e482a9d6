// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rates/body_rates.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/bodies/clamping.h"

#include <Eigen/Geometry>

namespace sheetmorph::surface
{

namespace
{

Points rates_of(const Carriers& carriers, const TargetRates& rates, Points PropagatedRate::*values)
{
    Points found(static_cast<Eigen::Index>(carriers.places.size()), 3);
    for (std::size_t row = 0; row < carriers.places.size(); ++row)
    {
        const auto [region, k] = carriers.places[row];
        found.row(static_cast<Eigen::Index>(row)) =
            (rates.propagated[region].*values).row(static_cast<Eigen::Index>(k));
    }
    return found;
}

// The spin of what the carriers' own rotations make of a body.
Vector3 mean_spin(const Carriers& carriers, const Points& spins, const Matrix3& mean)
{
    Matrix3 sum = Matrix3::Zero(), rate = Matrix3::Zero();
    for (std::size_t k = 0; k < carriers.rotations.size(); ++k)
    {
        sum += carriers.rotations[k];
        rate += cross_matrix(spins.row(static_cast<Eigen::Index>(k))) * carriers.rotations[k];
    }
    return spin_of_polar(mean, sum, rate);
}

Matrix3 mean_rotation(const Carriers& carriers)
{
    Matrix3 sum = Matrix3::Zero();
    for (const Matrix3& rotation : carriers.rotations)
        sum += rotation;
    return nearest_rotation(sum);
}

// Of a body that propagated vertices carry.
MotionRate carried_rate(const PlacementInput& part, int index, const BodyMotions& known,
                        const TargetsInMotion& pose)
{
    const Body& body = part.roles.bodies[at(index)];
    if (body.restricted >= 0 || body.following)
        throw NoDerivative(names_of(body, part.constraints).full()
                           + " is carried by another part, and bound besides");
    const Carriers carriers = carriers_of(part, index, pose.targets);
    const Points moves = rates_of(carriers, pose.rates, &PropagatedRate::positions);
    const RigidMotion& motion = known.motions[at(index)];
    MotionRate rate;
    if (body.driver >= 0)
    {
        rate.log =
            part.constraints.features[at(body.driver)].rotation == FeatureRotation::prescribed
                ? pose.rates.feature_logs[at(body.driver)]
                : Vector3(Vector3::Zero());
        rate.spin = spin_of_log(motion.rotation_log, rate.log);
    }
    else
    {
        const Matrix3 mean = mean_rotation(carriers);
        const Points spins = rates_of(carriers, pose.rates, &PropagatedRate::spins);
        rate.spin = best_motion_spin(carriers.rest, carriers.targets, moves,
                                     {mean, mean_spin(carriers, spins, mean)});
        const Vector3 log = known.logs.row(index).transpose();
        require_whole_log(motion.rotation(), log);
        rate.log = log_rate_of_spin(log, rate.spin);
    }
    const Vector3 middle = carriers.rest.colwise().mean().transpose();
    const Vector3 moved = moves.colwise().mean().transpose();
    rate.shift = moved + rate.spin.cross(motion.rotation() * (body.centre - middle));
    return rate;
}

}  // namespace

std::vector<MotionRate> known_body_rates(const PlacementInput& part, const BodyMotions& known,
                                         const TargetsInMotion& pose)
{
    std::vector<MotionRate> found(part.roles.bodies.size());
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        const Body& body = part.roles.bodies[k];
        if (body.following)
            throw NoDerivative(names_of(body, part.constraints).full()
                               + " keeps a link to another one");
        if (body.motion == Body::Motion::handle)
            found[k] = pose.rates.handles[at(body.driver)].about(
                pose.targets.handles[at(body.driver)], body.centre);
        else if (body.motion == Body::Motion::propagated)
            found[k] = carried_rate(part, static_cast<int>(k), known, pose);
        else if (body.motion == Body::Motion::prescribed
                 && part.constraints.features[at(body.driver)].rotation
                        == FeatureRotation::prescribed)
        {
            found[k].log = pose.rates.feature_logs[at(body.driver)];
            found[k].spin = spin_of_log(known.motions[k].rotation_log, found[k].log);
        }
    }
    return found;
}

KnownRotations given_rotation_rates(const PlacementInput& part, const TargetRates& rates,
                                    const std::vector<MotionRate>& bodies)
{
    const auto rows = [](const auto& list, auto log)
    {
        Points found(static_cast<Eigen::Index>(list.size()), 3);
        for (std::size_t k = 0; k < list.size(); ++k)
            found.row(static_cast<Eigen::Index>(k)) = log(list[k]).transpose();
        return found;
    };
    KnownRotations given;
    given.bodies = rows(bodies, [](const MotionRate& rate) { return rate.log; });
    given.handles = rows(rates.handles, [](const MotionRate& rate) { return rate.log; });
    given.points = rows(rates.points, [](const PointTarget& rate) { return rate.rotation_log; });
    given.regions = rows(rates.propagated, [](const PropagatedRate& rate)
                         { return Vector3(rate.rotation_logs.colwise().mean().transpose()); });
    given.vertices = Points::Zero(part.rest.vertex_count(), 3);
    for (int i = 0; i < part.rest.vertex_count(); ++i)
    {
        const int owner = part.roles.owner[at(i)];
        if (part.roles.role[at(i)] == Role::handle)
            given.vertices.row(i) = given.handles.row(owner);
        else if (part.roles.role[at(i)] == Role::body)
            given.vertices.row(i) = given.bodies.row(owner);
    }
    for (std::size_t region = 0; region < rates.propagated.size(); ++region)
    {
        const VertexIds& vertices = part.constraints.propagated[region].vertices;
        for (std::size_t k = 0; k < vertices.size(); ++k)
            if (part.roles.role[at(vertices[k])] == Role::propagated)
                given.vertices.row(vertices[k]) =
                    rates.propagated[region].rotation_logs.row(static_cast<Eigen::Index>(k));
    }
    turn_clamped(part.roles, given);
    return given;
}

Eigen::MatrixXd known_velocities(const PlacementInput& part, const TargetsInMotion& pose,
                                 const BodyMotions& motions, const std::vector<MotionRate>& bodies)
{
    Eigen::MatrixXd velocities = Eigen::MatrixXd::Zero(part.rest.vertex_count(), 3);
    for (std::size_t region = 0; region < pose.rates.propagated.size(); ++region)
    {
        const VertexIds& vertices = part.constraints.propagated[region].vertices;
        for (std::size_t k = 0; k < vertices.size(); ++k)
            if (part.roles.role[at(vertices[k])] == Role::propagated)
                velocities.row(vertices[k]) =
                    pose.rates.propagated[region].positions.row(static_cast<Eigen::Index>(k));
    }
    for (int i = 0; i < part.rest.vertex_count(); ++i)
    {
        const Vector3 point = part.rest.points().row(i).transpose();
        const int owner = part.roles.owner[at(i)];
        if (part.roles.role[at(i)] == Role::handle)
            velocities.row(i) =
                pose.rates.handles[at(owner)].at(pose.targets.handles[at(owner)], point);
        else if (part.roles.role[at(i)] == Role::body)
            velocities.row(i) = bodies[at(owner)].at(motions.motions[at(owner)], point);
    }
    return velocities;
}

void move_clamped(const PlacementInput& part, const KnownRotations& given,
                  const KnownRotations& rates, Eigen::MatrixXd& velocities)
{
    for (const Clamp& clamp : part.roles.clamps)
    {
        Vector3 mean = Vector3::Zero();
        for (const Clamp::Carrier& carrier : clamp.carriers)
        {
            const Vector3 arm = part.rest.points().row(clamp.vertex).transpose()
                                - part.rest.points().row(carrier.vertex).transpose();
            const Vector3 log = given.vertices.row(carrier.vertex).transpose();
            const Vector3 spin = spin_of_log(log, rates.vertices.row(carrier.vertex).transpose());
            const Vector3 moved = velocities.row(carrier.vertex).transpose();
            mean += carrier.weight * (moved + spin.cross(rotation_from_log(log) * arm));
        }
        velocities.row(clamp.vertex) = mean.transpose();
    }
}

}  // namespace sheetmorph::surface

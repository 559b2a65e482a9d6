// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rates/pose_rates.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/surface/features/turner_field.h"
#include "sheetmorph/surface/operators/point_rows.h"
#include "sheetmorph/surface/rates/body_rates.h"
#include "sheetmorph/surface/solve/placement.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// As of exact answers.
constexpr int most_refinements = 8;

void require_plain(const PreparedSurface& part)
{
    if (part.constraints.energy == Energy::steel)
        throw NoDerivative("answers of the energy 'steel' are not differentiated");
    if (part.constraints.is_refined)
        throw NoDerivative("answers that are refined for large rotations are not differentiated");
}

}  // namespace

//! One direction on its way.
struct PoseRates::Direction
{
    const TargetRates& rates;
    TargetsInMotion pose;
    std::vector<MotionRate> bodies;
    KnownRotations given;
    Points logs;                       // (n, 3) of the field, then of the sheet
    std::vector<Vector3> field_spins;  // (n)
    std::vector<Vector3> turner_spins;
    Eigen::MatrixXd wanted;  // (k, 3) of points
};

PoseRates::PoseRates(const PreparedSurface& part, SurfaceTargets targets)
    : part_(part),
      placement_(part.placement()),
      targets_(std::move(targets)),
      sizes_(size_changes(part.constraints, part.shapes, targets_)),
      known_(known_body_motions(placement_, targets_)),
      given_(given_rotations(placement_, targets_, known_)),
      field_(field_of(part, given_)),
      start_(known_),
      shares_(shares_of_field(part))
{
    require_plain(part);
    if (given_.is_tilted)
        throw NoDerivative(
            "a sheet is turned by about a whole turn, or several contacts turn one vertex");
    if (field_.far.rows() > 0)
        throw NoDerivative(
            "answers of 'natural' are not differentiated beyond turns of 60 degrees");
    turn_open_bodies(placement_, field_.logs, field_.tilts, start_);
    bodies_ = start_;
    logs_ = field_.logs;
    for (Eigen::Index i = 0; i < field_.logs.rows(); ++i)
        turns_.push_back(rotation_from_log(field_.logs.row(i).transpose()));
    if (part.responses)
        solve_turners();
}

void PoseRates::solve_turners()
{
    const FeatureResponses& responses = *part_.responses;
    for (const Turner& turner : responses.turners())
        if (!turner.turns)
            throw NoDerivative("a feature's motion is bound while its rotation is given");
    numerics::ConstrainedMinimiser::Targets asked;
    asked.constraints = point_displacements(part_.rest, part_.constraints.points, targets_.points);
    turned_.emplace(turned_features(part_, {targets_, start_, field_}, asked));
    if (turned_->is_held)
        throw NoDerivative("features are held where the sheet turns by more than a right angle");
    const Joints& joints = turned_->joints;
    const Measure measure{placement_, responses, turned_->energy};
    expansion_ = expand(joints, measure, forces_at(joints, measure));
    for (std::size_t k = 0; k < joints.states().size(); ++k)
        if (const int body = responses.turners()[k].body; body >= 0)
            bodies_.motions[at(body)] = motion_of(part_.roles.bodies[at(body)], joints.states()[k],
                                                  start_.motions[at(body)].rotation_log);
    blend_logs(responses, joints.states(), logs_);
}

DeformationRate PoseRates::along(const TargetRates& rates) const
{
    const TargetsInMotion pose{targets_, rates};
    Direction direction{rates, pose, known_body_rates(placement_, known_, pose), {}, {}, {},
                        {},    {}};
    direction.given = given_rotation_rates(placement_, rates, direction.bodies);
    direction.logs = part_.field->spread(direction.given).logs;
    for (Eigen::Index i = 0; i < direction.logs.rows(); ++i)
        direction.field_spins.push_back(
            spin_of_log(field_.logs.row(i).transpose(), direction.logs.row(i).transpose()));
    direction.wanted.resize(static_cast<Eigen::Index>(rates.points.size()), 3);
    for (std::size_t k = 0; k < rates.points.size(); ++k)
        direction.wanted.row(static_cast<Eigen::Index>(k)) = rates.points[k].position.transpose();
    turn_open(direction);
    if (turned_)
        turn_features(direction);
    const Eigen::MatrixXd velocities = part_.minimiser.solve(
        asked(direction, direction.turner_spins, direction.bodies), most_refinements);
    complete(direction, velocities);
    DeformationRate rate = placed(direction, velocities);
    part_.followers.place_rates(part_.rest, logs_, rate.positions, rate.rotation_logs);
    grow(rates, rate);
    return rate;
}

// Bodies whose rotation is the field's.
void PoseRates::turn_open(Direction& direction) const
{
    for (std::size_t k = 0; k < part_.roles.bodies.size(); ++k)
    {
        const Body& body = part_.roles.bodies[k];
        if (body.is_known())
            continue;
        const int first = body.vertices.front();
        direction.bodies[k].log = direction.logs.row(first).transpose();
        direction.bodies[k].spin = direction.field_spins[at(first)];
    }
}

// (n) of turns_of(), where turners turn with `spins`, or are not there if it is empty.
std::vector<Matrix3> PoseRates::turn_rates(const Direction& direction,
                                           const std::vector<Vector3>& spins) const
{
    std::vector<Matrix3> change(turns_.size());
    std::vector<Matrix3> turns;
    for (std::size_t k = 0; k < spins.size(); ++k)
        turns.push_back(cross_matrix(spins[k]) * turned_->joints.states()[k].rotation);
    for (std::size_t i = 0; i < change.size(); ++i)
    {
        const auto vertex = static_cast<Eigen::Index>(i);
        change[i] = shares_(vertex) * cross_matrix(direction.field_spins[i]) * turns_[i];
        if (!turns.empty())
            for (auto entry = part_.responses->weights().at_vertex(vertex); entry; ++entry)
                change[i] += entry.value() * turns[at(entry.col())];
    }
    return change;
}

// Of ask().
numerics::ConstrainedMinimiser::Targets PoseRates::asked(
    const Direction& direction, const std::vector<Vector3>& spins,
    const std::vector<MotionRate>& bodies) const
{
    const std::vector<Matrix3> change = turn_rates(direction, spins);
    Eigen::MatrixXd velocities = known_velocities(placement_, direction.pose, bodies_, bodies);
    move_clamped(placement_, given_.logs, direction.given, velocities);
    return {turned_rows(part_.operators, change), std::move(velocities), direction.wanted};
}

// How turners change while the joints' own numbers stay: handles that turn freely are shifted.
std::vector<StateRate> PoseRates::driven(const TargetRates& rates) const
{
    std::vector<StateRate> found(turned_->joints.states().size());
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        const int index = part_.responses->turners()[k].body;
        if (index < 0 || part_.roles.bodies[at(index)].handle < 0)
            continue;
        const MotionRate& rate = rates.handles[at(part_.roles.bodies[at(index)].handle)];
        const Matrix3& rotation = turned_->joints.states()[k].rotation;
        found[k].centre = rate.shift + rate.pivot - rotation * rate.pivot;
    }
    return found;
}

// The minimum's gradient stays zero: the Hessian times the change of the joints' numbers is the
// change of the forces.
void PoseRates::turn_features(Direction& direction) const
{
    const FeatureResponses& responses = *part_.responses;
    std::vector<MotionRate> unmoved = direction.bodies;
    for (const Turner& turner : responses.turners())
        if (turner.body >= 0)
            unmoved[at(turner.body)] = {};
    const numerics::ConstrainedMinimiser::Targets wanted = asked(direction, {}, unmoved);
    const numerics::ConstrainedMinimiser::Solution base =
        part_.minimiser.minimum(wanted, most_refinements);
    std::vector<StateRate> states = driven(direction.rates);
    Eigen::MatrixXd entries = Eigen::MatrixXd::Zero(turned_->energy.slope.rows(), 3);
    for (std::size_t k = 0; k < states.size(); ++k)
        if (const int row = responses.columns()[k].shift; row >= 0)
            entries.row(row) = states[k].centre.transpose();
    const Eigen::MatrixXd forces =
        responses.slopes(wanted, base) + turned_->energy.stiffness * entries;
    Expansion change = expansion_;
    change.gradient = gradient_of(turned_->joints, responses, forces);
    const Eigen::VectorXd steps =
        turned_->joints.freedoms() > 0 ? newton_step(change) : change.gradient;
    const std::vector<StateRate> found = state_rates(turned_->joints, steps);
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        states[k].spin += found[k].spin;
        states[k].centre += found[k].centre;
        direction.turner_spins.push_back(states[k].spin);
        if (const int body = responses.turners()[k].body; body >= 0)
            direction.bodies[at(body)] = {states[k].centre, Vector3::Zero(), Vector3::Zero(),
                                          states[k].spin};
    }
    blend(direction);
}

// Of blend_logs().
void PoseRates::blend(Direction& direction) const
{
    const Points field = direction.logs;
    const FeatureResponses& responses = *part_.responses;
    Points rates = Points::Zero(static_cast<Eigen::Index>(direction.turner_spins.size()), 3);
    for (std::size_t k = 0; k < direction.turner_spins.size(); ++k)
    {
        const Turner& turner = responses.turners()[k];
        if (turner.vertices.empty())
            continue;
        const Matrix3& rotation = turned_->joints.states()[k].rotation;
        const Vector3 log =
            log_near(rotation, field_.logs.row(turner.vertices.front()).transpose());
        require_whole_log(rotation, log);
        rates.row(static_cast<Eigen::Index>(k)) =
            log_rate_of_spin(log, direction.turner_spins[k]).transpose();
    }
    for (Eigen::Index i = 0; i < field.rows() && rates.rows() > 0; ++i)
        for (auto entry = responses.weights().at_vertex(i); entry; ++entry)
            direction.logs.row(i) += entry.value() * (rates.row(entry.col()) - field.row(i));
}

// Bodies that the sheet shifts.
void PoseRates::complete(Direction& direction, const Eigen::MatrixXd& velocities) const
{
    for (std::size_t k = 0; k < part_.roles.bodies.size(); ++k)
    {
        const Body& body = part_.roles.bodies[k];
        MotionRate& rate = direction.bodies[k];
        const RigidMotion& motion = bodies_.motions[k];
        if (body.is_open())
        {
            const int first = body.vertices.front();
            const Vector3 start = part_.rest.points().row(first).transpose();
            rate.shift.setZero();
            rate.shift = velocities.row(first).transpose() - rate.at(motion, start);
        }
        if (!body.is_known() && !rate.spin.isZero(0.0))
        {
            require_whole_log(motion.rotation(), motion.rotation_log);
            rate.log = log_rate_of_spin(motion.rotation_log, rate.spin);
        }
    }
}

DeformationRate PoseRates::placed(const Direction& direction,
                                  const Eigen::MatrixXd& velocities) const
{
    DeformationRate rate{velocities, direction.logs, {}};
    const Eigen::MatrixXd known =
        known_velocities(placement_, direction.pose, bodies_, direction.bodies);
    for (int i = 0; i < part_.rest.vertex_count(); ++i)
    {
        const Role role = part_.roles.role[at(i)];
        if (role == Role::propagated || role == Role::handle || role == Role::body)
            rate.positions.row(i) = known.row(i);
    }
    rate.features.resize(part_.constraints.features.size());
    for (std::size_t k = 0; k < part_.roles.bodies.size(); ++k)
        for (const int feature : part_.roles.bodies[k].features)
            rate.features[at(feature)] = direction.bodies[k].about(
                bodies_.motions[k],
                centre_of(part_.rest, part_.constraints.features[at(feature)].vertices));
    return rate;
}

// Of SheetGrowth::lay().
void PoseRates::grow(const TargetRates& rates, DeformationRate& rate) const
{
    const auto is_set = [](const std::optional<double>& size) { return size.has_value(); };
    if (std::none_of(sizes_.begin(), sizes_.end(), is_set))
        return;
    const Points growth = part_.growth.field(sizes_);
    const Points change = part_.growth.field_rate(sizes_, rates.sizes);
    const auto add = [&](int vertex, const Matrix3& turn, const Vector3& spin)
    {
        const Vector3 grown = turn * growth.row(vertex).transpose();
        const Vector3 more = turn * change.row(vertex).transpose();
        rate.positions.row(vertex) += (spin.cross(grown) + more).transpose();
    };
    for (int vertex = 0; vertex < part_.rest.vertex_count(); ++vertex)
        if (part_.growth.moves(vertex))
        {
            const Vector3 log = logs_.row(vertex).transpose();
            add(vertex, rotation_from_log(log),
                spin_of_log(log, rate.rotation_logs.row(vertex).transpose()));
        }
    for (std::size_t body = 0; body < part_.roles.bodies.size(); ++body)
        for (const int feature : part_.roles.bodies[body].features)
        {
            if (!sizes_[at(feature)])
                continue;
            VertexIds vertices = part_.constraints.features[at(feature)].vertices;
            make_set(vertices);
            for (const int vertex : vertices)
                add(vertex, bodies_.motions[body].rotation(), rate.features[at(feature)].spin);
        }
    part_.followers.place_rates(part_.rest, logs_, rate.positions, rate.rotation_logs);
}

}  // namespace sheetmorph::surface

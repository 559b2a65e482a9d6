// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/pose_solve.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/constraints/constraint_checks.h"
#include "sheetmorph/surface/features/reduced_minimum.h"
#include "sheetmorph/surface/features/turner_field.h"
#include "sheetmorph/surface/operators/point_rows.h"
#include "sheetmorph/surface/solve/placement.h"
#include "sheetmorph/surface/solve/pose_steps.h"
#include "sheetmorph/surface/solve/reachable_size.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::surface
{

namespace
{

// Clean meshes converge after one or two; meshes with a few needles need more. Chosen: each one
// costs a back-substitution.
constexpr int most_refinements = 8;

// Limits for the final correction of the rotating bodies, in radians. Already converged: from the
// rounding of a rotation (1e-16) with a margin. Converged after one more step: the error left is
// below its square, 1e-16. Acceptable at the end: the accuracy that SheetMorph promises. Number of
// steps: chosen; the first one takes nearly all of the correction.
constexpr double settled_turn = 1e-13;
constexpr double small_turn = 1e-8;
constexpr double found_turn = 1e-9;
constexpr int most_turns = 3;

void require_met_points(const PreparedSurface& part, const Eigen::MatrixXd& displacements,
                        const Eigen::MatrixXd& wanted, Exactness level)
{
    const Eigen::VectorXd error = part.minimiser.constraint_error(displacements, wanted);
    const double reach = part.rest.size() + (wanted.size() ? wanted.cwiseAbs().maxCoeff() : 0.0);
    // Exactness::live promises 1e-6 of the size.
    const double allowed =
        level == Exactness::exact ? mesh::exactness(part.rest.points(), reach) : 1e-6 * reach;
    Text missed("");
    for (Eigen::Index k = 0; k < error.size(); ++k)
        if (error(k) > allowed)
        {
            const PointConstraint& point = part.constraints.points[at(k)];
            missed +=
                (missed.is_empty() ? "" : ", ") + Text::about("'" + point.name + "'", point.of);
        }
    if (!missed.is_empty())
        throw InvalidInput("the targets of points " + missed
                           + " contradict each other or the fixed, handle or feature vertices they "
                             "lie on", "move a target or remove a point");
}

//! Intermediate state of one pose.
struct Solving
{
    const SurfaceTargets& targets;
    Exactness exactness;
    BodyMotions bodies;
    Field field;
    numerics::ConstrainedMinimiser::Targets asked;
    Convergence convergence = {};

    int refinements() const { return exactness == Exactness::exact ? most_refinements : 0; }

    // Does not report the linear solution of a steel sheet, because the shell iterates from there.
    void join_linear(const PreparedSurface& part, const Convergence& found)
    {
        if (!part.steel || exactness != Exactness::exact)
            convergence.join(found);
    }
};

//! The rotating bodies, and the bodies and the field before their rotation.
struct Turning
{
    const BodyMotions& start;
    const Field& field;
    Turned turned;
};

// Copies the states of the joints to bodies and field.
void take_turns(const PreparedSurface& part, const Turning& turning, Solving& pose)
{
    const std::vector<BodyState>& states = turning.turned.joints.states();
    for (std::size_t k = 0; k < states.size(); ++k)
        if (const int body = part.responses->turners()[k].body; body >= 0)
            pose.bodies.motions[at(body)] = motion_of(part.roles.bodies[at(body)], states[k],
                                                      turning.start.motions[at(body)].rotation_log);
    pose.field.logs = turning.field.logs;
    blend_logs(*part.responses, states, pose.field.logs);
}

void ask_turned(const PreparedSurface& part, const Turning& turning, Solving& pose)
{
    const std::vector<Matrix3> turns =
        turns_of(part, turning.field, turning.turned.joints.states());
    ask(part, turns, {pose.targets, turning.field, pose.bodies}, pose.asked);
}

// Corrects the joints by the difference between the slope of the solved sheet and the slope that
// the responses predict. The responses are accurate to rounding of a rigid sheet's energy only.
// \returns the change, radians or relative to the size
double turn_on(const PreparedSurface& part, const numerics::ConstrainedMinimiser::Solution& found,
               const numerics::ConstrainedMinimiser::Targets& asked, Turned& turned)
{
    const PlacementInput placement = part.placement();
    const FeatureResponses& responses = *part.responses;
    const Eigen::MatrixXd before = entries_of(turned.joints, placement, responses);
    const Eigen::MatrixXd told = responses.stiffness() * before + turned.slope;
    const Eigen::MatrixXd missed = responses.slopes(asked, found) - told;
    turned.slope += missed;
    turned.energy.slope += missed;
    turned.convergence = minimise(turned.joints, {placement, responses, turned.energy}, small_turn);
    Eigen::MatrixXd change = entries_of(turned.joints, placement, responses) - before;
    for (const TurnerColumns& columns : responses.columns())
        if (columns.shift >= 0)
            change.row(columns.shift) /= part.rest.size();
    return change.cwiseAbs().maxCoeff();
}

// Repeats the correction until the rotating bodies no longer move.
void settle(const PreparedSurface& part, Turning& turning, Solving& pose,
            numerics::ConstrainedMinimiser::Solution& found)
{
    Convergence settled{turning.turned.convergence.what, false, 0, 0.0, "radians"};
    while (!settled.is_converged && settled.rounds < most_turns)
    {
        ++settled.rounds;
        settled.miss = turn_on(part, found, pose.asked, turning.turned);
        settled.is_converged = settled.miss <= small_turn;
        if (settled.miss <= settled_turn)
            break;
        const numerics::ConstrainedMinimiser::Targets before = pose.asked;
        take_turns(part, turning, pose);
        ask_turned(part, turning, pose);
        const numerics::ConstrainedMinimiser::Targets more{
            pose.asked.rows - before.rows, pose.asked.offset - before.offset,
            Eigen::MatrixXd::Zero(before.constraints.rows(), before.constraints.cols())};
        const numerics::ConstrainedMinimiser::Solution further = part.minimiser.minimum(more, 0);
        found.u += further.u;
        found.multipliers += further.multipliers;
    }
    settled.is_converged |= settled.miss <= found_turn;
    pose.join_linear(part, settled);
}

// Minimises over the rotating bodies. A live frame can combine precomputed displacements.
Eigen::MatrixXd turned_displacements(const PreparedSurface& part, Solving& pose)
{
    const BodyMotions start = pose.bodies;
    const Field field = pose.field;
    const bool is_exact = pose.exactness == Exactness::exact;
    Turning turning{start, field,
                    turned_features(part, {pose.targets, start, field, 0, small_turn}, pose.asked)};
    const Turned& turned = turning.turned;
    pose.join_linear(part, turned.convergence);
    take_turns(part, turning, pose);
    if (!is_exact)
        if (const auto change = part.responses->displacements(
                entries_of(turned.joints, part.placement(), *part.responses)))
            return turned.base.u + *change;
    ask_turned(part, turning, pose);
    numerics::ConstrainedMinimiser::Solution found =
        part.minimiser.minimum(pose.asked, pose.refinements());
    pose.join_linear(part, found.convergence);
    if (is_exact)
        settle(part, turning, pose, found);
    return std::move(found.u);
}

Eigen::MatrixXd solved_displacements(const PreparedSurface& part, Solving& pose)
{
    if (part.responses)
        return turned_displacements(part, pose);
    ask(part, turns_of(part, pose.field, {}), {pose.targets, pose.field, pose.bodies}, pose.asked);
    numerics::ConstrainedMinimiser::Solution found =
        part.minimiser.minimum(pose.asked, pose.refinements());
    pose.join_linear(part, found.convergence);
    return std::move(found.u);
}

// Continues from the linear result to that of the steel sheet.
void stiffen(const PreparedSurface& part, Solving& pose, Deformation& result,
             const Progress& progress)
{
    const PlacementInput placement = part.placement();
    const ShellPose linear{placement, pose.targets, pose.bodies, result.positions,
                           result.rotation_logs};
    SteelAnswer::Shape shape = part.steel->solve(linear, progress);
    pose.bodies = std::move(shape.bodies);
    const Eigen::MatrixXd displacements = shape.positions - part.rest.points();
    require_met_points(part, displacements, pose.asked.constraints, pose.exactness);
    result.positions = placed_positions(placement, pose.targets, pose.bodies, displacements);
    result.rotation_logs = std::move(shape.logs);
    result.convergence.join(shape.convergence);
}

Deformation solved(const PreparedSurface& part, const SurfaceTargets& targets, Exactness exactness,
                   const Progress& progress)
{
    check_targets(part.constraints, targets);
    const PlacementInput placement = part.placement();
    Solving pose{targets, exactness, known_body_motions(placement, targets), {}, {}, {}};
    pose.field = field_of(part, given_rotations(placement, targets, pose.bodies));
    pose.convergence.join(part.operators.convergence);
    pose.convergence.join(pose.field.convergence);
    turn_open_bodies(placement, pose.field.logs, pose.field.tilts, pose.bodies);
    pose.asked.constraints =
        point_displacements(part.rest, part.constraints.points, targets.points);
    const Eigen::MatrixXd displacements = solved_displacements(part, pose);
    require_met_points(part, displacements, pose.asked.constraints, exactness);
    complete_bodies(placement, displacements, pose.bodies);
    Deformation result;
    result.rotation_logs = pose.field.logs;
    result.convergence = pose.convergence;
    result.is_preview = part.constraints.has_previews() && exactness == Exactness::live;
    result.positions = placed_positions(placement, targets, pose.bodies, displacements);
    if (part.steel && exactness == Exactness::exact)
        stiffen(part, pose, result, progress);
    part.followers.place(part.rest, result.positions, result.rotation_logs);
    result.features = feature_motions(placement, pose.bodies);
    if (!result.positions.allFinite())
        throw SolverError("the deformed shape is not finite", "the mesh may be too distorted");
    return result;
}

}  // namespace

Deformation solve_pose(const PreparedSurface& part, const SurfaceTargets& targets,
                       Exactness exactness, const Progress& progress)
{
    const SizeChanges sizes = size_changes(part.constraints, part.shapes, targets);
    Deformation result = solved(part, targets, exactness, progress);
    const auto is_set = [](const std::optional<double>& size) { return size.has_value(); };
    if (std::none_of(sizes.begin(), sizes.end(), is_set))
        return result;
    if (exactness == Exactness::exact)
        require_reachable_sizes(part, sizes, result);
    part.growth.lay(sizes, result);
    part.followers.place(part.rest, result.positions, result.rotation_logs);
    return result;
}

}  // namespace sheetmorph::surface

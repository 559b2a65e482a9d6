// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/pose_solve.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/constraint_checks.h"
#include "sheetmorph/surface/operators/point_rows.h"
#include "sheetmorph/surface/rotation/turner_field.h"
#include "sheetmorph/surface/solve/placement.h"
#include "sheetmorph/surface/solve/pose_steps.h"
#include "sheetmorph/surface/solve/reachable_size.h"
#include "sheetmorph/surface/solve/reduced_minimum.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

// Clean meshes settle after one or two; a few needles in the mesh need more.
constexpr int most_refinements = 8;

void require_met_points(const PreparedSurface& part, const Eigen::MatrixXd& displacements,
                        const Eigen::MatrixXd& wanted, Exactness level)
{
    const Eigen::VectorXd error = part.minimiser.constraint_error(displacements, wanted);
    const double reach = part.rest.size() + (wanted.size() ? wanted.cwiseAbs().maxCoeff() : 0.0);
    const double allowed =
        level == Exactness::exact ? exactness(part.rest.points(), reach) : 1e-6 * reach;
    std::string missed;
    for (Eigen::Index k = 0; k < error.size(); ++k)
        if (error(k) > allowed)
            missed += (missed.empty() ? "'" : ", '") + part.constraints.points[at(k)].name + "'";
    if (!missed.empty())
        throw InvalidInput("the targets of points " + missed
                           + " contradict each other or the fixed, handle or feature vertices they "
                             "lie on; move a target or remove a point");
}

//! One pose on its way to its solution.
struct Solving
{
    const SurfaceTargets& targets;
    Exactness exactness;
    BodyMotions bodies;
    Field field;
    ConstrainedMinimiser::Targets asked;
    Convergence convergence = {};
    std::vector<Matrix3> turns = {};  // R - I at every vertex

    int refinements() const { return exactness == Exactness::exact ? most_refinements : 0; }

    // A start that has not settled is no fault of the steel sheet that settles from it.
    void join_linear(const PreparedSurface& part, const Convergence& found)
    {
        if (!part.steel || exactness != Exactness::exact)
            convergence.join(found);
    }
};

// Lets the energy turn what it may turn; the sheet's displacements, known already in a live frame.
std::optional<Eigen::MatrixXd> turn_features(const PreparedSurface& part, Solving& pose)
{
    const BodyMotions start = pose.bodies;
    const Field field = pose.field;
    const int refinements = std::min(pose.refinements(), 1);
    const Turned turned =
        turned_features(part, {pose.targets, start, field, refinements}, pose.asked);
    const Joints& joints = turned.joints;
    pose.join_linear(part, turned.convergence);
    for (std::size_t k = 0; k < joints.states().size(); ++k)
    {
        const int body = part.responses->turners()[k].body;
        if (body >= 0)
            pose.bodies.motions[at(body)] =
                motion_of(part.roles.bodies[at(body)], joints.states()[k],
                          pose.bodies.motions[at(body)].rotation_log);
    }
    blend_logs(*part.responses, joints.states(), pose.field.logs);
    if (pose.exactness == Exactness::live)
    {
        const Eigen::MatrixXd rho = entries_of(joints, part.placement(), *part.responses);
        if (const auto change = part.responses->displacements(rho))
            return turned.base.u + *change;
    }
    pose.turns = turns_of(part, field, joints.states());
    return std::nullopt;
}

Eigen::MatrixXd solved_displacements(const PreparedSurface& part, Solving& pose)
{
    if (part.responses)
    {
        if (std::optional<Eigen::MatrixXd> known = turn_features(part, pose))
            return *known;
    }
    else
        pose.turns = turns_of(part, pose.field, {});
    ask(part, pose.turns, {pose.targets, pose.bodies}, pose.asked);
    ConstrainedMinimiser::Solution found = part.minimiser.minimum(pose.asked, pose.refinements());
    pose.join_linear(part, found.convergence);
    return std::move(found.u);
}

// From the linear answer to that of the steel sheet.
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
        throw SolverError("the deformed shape is not finite; the mesh may be too distorted");
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

}  // namespace sheetmorph

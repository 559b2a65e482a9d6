// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/pose_steps.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotations/rotation_batch.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/surface/features/reduced_minimum.h"
#include "sheetmorph/surface/features/turner_field.h"
#include "sheetmorph/surface/solve/placement.h"

namespace sheetmorph::surface
{

namespace
{

// Fewest vertices for a thread. Chosen, not measured.
constexpr Eigen::Index least_turned = 1000;

}  // namespace

Field field_of(const PreparedSurface& part, const GivenRotations& given)
{
    SpreadRotations found = part.field->spread(given.logs);
    Field field{std::move(found.logs), Points::Zero(part.rest.vertex_count(), 3), Points(0, 3),
                found.convergence};
    if (given.is_tilted)
    {
        found = part.field->spread(given.tilts);
        field.tilts = std::move(found.logs);
        field.convergence.join(found.convergence);
    }
    if (part.far_turns)
    {
        FarField far = part.far_turns->bent(given, std::move(field.logs), field.tilts);
        field.logs = std::move(far.logs);
        field.far = std::move(far.rows);
    }
    return field;
}

Eigen::VectorXd shares_of_field(const PreparedSurface& part)
{
    const Eigen::Index count = part.rest.vertex_count();
    if (!part.responses)
        return Eigen::VectorXd::Ones(count);
    Eigen::VectorXd shares(count);
    for (Eigen::Index i = 0; i < count; ++i)
        shares(i) = 1.0 - part.responses->weights().sum(i);
    return shares;
}

std::vector<Matrix3> turns_of(const PreparedSurface& part, const Field& field,
                              const std::vector<BodyState>& turns)
{
    const SmoothWeights none(part.rest.vertex_count());
    const SmoothWeights& weights = part.responses ? part.responses->weights() : none;
    std::vector<Matrix3> turn(at(part.rest.vertex_count()));
    const bool is_tilted = !field.tilts.isZero(0.0);
    const auto turn_vertices = [&](Eigen::Index begin, Eigen::Index end)
    {
        turns_from_logs(field.logs, begin, end, turn.data() + begin);
        for (Eigen::Index i = begin; i < end && (is_tilted || !weights.is_empty()); ++i)
        {
            Matrix3& change = turn[at(i)];
            if (is_tilted)
                change =
                    tilted_rotation(field.logs.row(i), field.tilts.row(i)) - Matrix3::Identity();
            double left = 1.0;
            for (auto entry = weights.at_vertex(i); entry; ++entry)
                left -= entry.value();
            change *= left;
            for (auto entry = weights.at_vertex(i); entry && !turns.empty(); ++entry)
                change += entry.value() * (turns[at(entry.col())].rotation - Matrix3::Identity());
        }
    };
    parallel_ranges(part.rest.vertex_count(), least_turned, turn_vertices);
    return turn;
}

void ask(const PreparedSurface& part, const std::vector<Matrix3>& change, const Told& told,
         numerics::ConstrainedMinimiser::Targets& asked)
{
    asked.rows = turned_rows(part.operators, change);
    if (told.field.far.rows() > 0)
        asked.rows += told.field.far;
    asked.offset = known_displacements(part.placement(), told.targets, told.bodies);
}

Turned turned_features(const PreparedSurface& part, const ToTurn& pose,
                       numerics::ConstrainedMinimiser::Targets& asked)
{
    const PlacementInput placement = part.placement();
    const FeatureResponses& responses = *part.responses;
    const BodyMotions unmoved = unmoved_turners(responses.turners(), pose.bodies);
    ask(part, turns_of(part, pose.field, {}), {pose.targets, pose.field, unmoved}, asked);
    numerics::ConstrainedMinimiser::Solution base = part.minimiser.minimum(asked, pose.refinements);
    ReducedEnergy energy = responses.energy(asked, base);
    Turned found{std::move(base),
                 energy.slope,
                 std::move(energy),
                 false,
                 Joints(placement, pose.targets, responses.turners(), pose.bodies),
                 {}};
    const std::vector<double> farthest = farthest_turns(responses, pose.field.logs);
    found.is_held = hold_far_turned(responses, farthest, found.joints, found.energy);
    found.convergence =
        minimise(found.joints, {placement, responses, found.energy}, pose.precision);
    return found;
}

}  // namespace sheetmorph::surface

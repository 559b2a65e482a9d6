// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/learning.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/surface/operators/point_rows.h"
#include "sheetmorph/surface/solve/pose_steps.h"

#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// Columns per substitution. Large parts get fewer, so that the end of a drag does not have to wait.
// Chosen: 12 fill the registers, 3 are one pose. Not measured: 2,000,000 entries are estimated at
// 0.1 s.
constexpr Eigen::Index most_together = 12;
constexpr Eigen::Index fewest_together = 3;
constexpr Eigen::Index entries_together = 2000000;

}  // namespace

Eigen::MatrixXd learnt_columns(const PoseNumbers& numbers, const std::vector<KnownPose>& poses)
{
    Eigen::MatrixXd columns;
    for (std::size_t k = 0; k < poses.size(); ++k)
    {
        const Points of_pose = numbers.of(poses[k], numbers.turns(poses[k]));
        if (k == 0)
            columns.resize(of_pose.rows(), 3 * static_cast<Eigen::Index>(poses.size()));
        columns.middleCols(3 * static_cast<Eigen::Index>(k), 3) = of_pose;
    }
    return columns;
}

// Sorts the columns by pose.
std::vector<LearntFields::Asked> LearntFields::in_order(
    const std::vector<Eigen::Index>& columns) const
{
    std::vector<Asked> asked;
    for (std::size_t k = 0; k < columns.size(); ++k)
        asked.push_back({static_cast<Eigen::Index>(k), at(columns[k] / 3), columns[k] % 3});
    std::stable_sort(asked.begin(), asked.end(),
                     [](const Asked& a, const Asked& b) { return a.pose < b.pose; });
    return asked;
}

// The rotation field of a pose at every vertex.
LearntFields::Field LearntFields::field(const KnownPose& pose) const
{
    const PoseNumbers::Turns known = numbers_.turns(pose);
    const Points logs = numerics::narrow_product(numbers_.field(), known.logs);
    if (known.tilts.rows() == 0)
        return {logs, Points::Zero(logs.rows(), 3)};
    return {logs, numerics::narrow_product(numbers_.field(), known.tilts)};
}

// The field's share of the sheet's rotation at every vertex, minus the identity.
std::vector<Matrix3> LearntFields::turns(const Field& field) const
{
    const Eigen::VectorXd left = shares_of_field(part_);
    std::vector<Matrix3> turns(at(field.logs.rows()));
    const auto turn = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index i = begin; i < end; ++i)
            turns[at(i)] =
                left(i)
                * (tilted_rotation(field.logs.row(i).transpose(), field.tilts.row(i).transpose())
                   - Matrix3::Identity());
    };
    parallel_ranges(field.logs.rows(), microsecond_items, turn);
    return turns;
}

// Displacements of prescribed vertices and bodies. Bodies with an interpolated rotation follow the
// field; those with a free rotation do not rotate.
Eigen::MatrixXd LearntFields::offset(const KnownPose& pose, const Field& field) const
{
    BodyMotions bodies = pose.bodies;
    turn_open_bodies(part_.placement(), field.logs, field.tilts, bodies);
    if (part_.responses != nullptr)
        bodies = unmoved_turners(part_.responses->turners(), bodies);
    return known_displacements(part_.placement(), pose.targets, bodies);
}

// Fills in the targets of the next columns, starting at `first`.
void LearntFields::ask(const std::vector<Asked>& asked, std::size_t first,
                       numerics::ConstrainedMinimiser::Targets& targets) const
{
    const SurfaceOperators& operators = part_.operators;
    std::vector<Matrix3> turned;
    Eigen::MatrixXd offsets, shifts;
    for (Eigen::Index k = 0; k < targets.offset.cols(); ++k)
    {
        const Asked& one = asked[first + at(k)];
        const KnownPose& pose = poses_[one.pose];
        if (k == 0 || one.pose != asked[first + at(k) - 1].pose)
        {
            const Field sheet = field(pose);
            turned = turns(sheet);
            offsets = offset(pose, sheet);
            shifts = point_displacements(part_.rest, part_.constraints.points, pose.targets.points);
        }
        targets.offset.col(k) = offsets.col(one.coordinate);
        targets.constraints.col(k) = shifts.col(one.coordinate);
        for (Eigen::Index row = 0; row < targets.rows.rows(); ++row)
            targets.rows(row, k) = turned[at(operators.row_vertices[at(row)])].row(one.coordinate)
                                   * operators.rest_rows.row(row).transpose();
    }
}

Eigen::MatrixXd LearntFields::solve(const std::vector<Eigen::Index>& columns,
                                    Eigen::MatrixXd& slopes, const Progress& progress) const
{
    const std::vector<Asked> asked = in_order(columns);
    const Eigen::Index n = part_.rest.vertex_count(), rows = part_.operators.rest_rows.rows();
    const auto points = static_cast<Eigen::Index>(part_.constraints.points.size());
    const auto count = static_cast<Eigen::Index>(columns.size());
    const Eigen::Index together =
        std::clamp(entries_together / std::max<Eigen::Index>(n, 1), fewest_together, most_together);
    const bool is_turned = part_.responses != nullptr;
    Eigen::MatrixXd answers(n, count);
    slopes.resize(is_turned ? part_.responses->stiffness().rows() : 0, count);
    for (Eigen::Index first = 0; first < count; first += together)
    {
        progress.report(static_cast<double>(first) / static_cast<double>(count), "response fields");
        const Eigen::Index width = std::min(together, count - first);
        numerics::ConstrainedMinimiser::Targets targets;
        targets.rows.resize(rows, width);
        targets.offset.resize(n, width);
        targets.constraints.resize(points, width);
        ask(asked, at(first), targets);
        const numerics::ConstrainedMinimiser::Solution answer =
            part_.minimiser.minimum(targets, is_turned ? 1 : 0);
        const Eigen::MatrixXd slope =
            is_turned ? part_.responses->slopes(targets, answer) : Eigen::MatrixXd(0, width);
        for (Eigen::Index k = 0; k < width; ++k)
        {
            answers.col(asked[at(first + k)].column) = answer.u.col(k);
            slopes.col(asked[at(first + k)].column) = slope.col(k);
        }
    }
    return answers;
}

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/live/sampled_response.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// By how much the numbers of a frame may miss being a blend: radians, about.
constexpr double largest_miss = 4e-7;

// The field may turn by no more around a free feature, or it would begin to be held
// (turner_field.h).
constexpr double farthest_turn = 0.5;

}  // namespace

bool SampledResponse::is_far_turned(const Points& logs) const
{
    for (const Around& around : around_)
        for (Eigen::Index k = 1; k < around.count; ++k)
            if ((logs.row(around.first + k) - logs.row(around.first)).norm() > farthest_turn)
                return true;
    return false;
}

// How the field turns the open bodies.
Points SampledResponse::open_logs(const DriverNumbers::Pose& pose) const
{
    Points logs = pose.logs.topRows(static_cast<Eigen::Index>(open_.size()));
    for (Eigen::Index k = 0; k < logs.rows(); ++k)
        if (const Vector3 tilt = pose.tilts.row(k).transpose(); !tilt.isZero(0.0))
        {
            const Vector3 log = logs.row(k).transpose();
            logs.row(k) =
                nearest_branch(log_from_rotation(tilted_rotation(log, tilt)), log).transpose();
        }
    return logs;
}

// Where the sheet takes them.
void SampledResponse::shift_bodies(Frame& frame) const
{
    const VertexRoles& roles = input_.part.roles;
    for (std::size_t k = 0; k < open_.size(); ++k)
    {
        const Vector3 start =
            input_.part.rest.points().row(roles.bodies[at(open_[k])].vertices.front()).transpose();
        RigidMotion& motion = frame.bodies.motions[at(open_[k])];
        motion.translation.setZero();
        motion.translation =
            (reads_rows_.row(static_cast<Eigen::Index>(k)) * frame.coefficients).transpose()
            - (motion.apply(start) - start);
    }
}

// What the sheet turns like where free features turn it.
void SampledResponse::blend_logs(Frame& frame) const
{
    if (blends_.empty())
        return;
    const Points field = frame.logs;
    for (const Blend& blend : blends_)
    {
        const Vector3 reference = field.row(around_[at(blend.turner)].first).transpose();
        const Vector3 log = log_near(frame.free[at(blend.turner)].rotation, reference);
        frame.logs.row(blend.row) += blend.weight * (log.transpose() - field.row(blend.row));
    }
}

std::optional<SampledResponse::Frame> SampledResponse::frame(const SurfaceTargets& targets) const
{
    const auto is_set = [](const std::optional<double>& size) { return size.has_value(); };
    if (basis_.columns() == 0 || std::any_of(targets.sizes.begin(), targets.sizes.end(), is_set))
        return std::nullopt;
    Frame frame;
    frame.bodies = known_body_motions(input_.part, targets);
    const DriverNumbers::Pose pose = drivers_.of(targets, frame.bodies);
    if (is_far_turned(pose.logs))
        return std::nullopt;
    frame.logs = pose.logs;
    const Points open = open_logs(pose);
    for (std::size_t k = 0; k < open_.size(); ++k)
        frame.bodies.motions[at(open_[k])].rotation_log =
            open.row(static_cast<Eigen::Index>(k)).transpose();
    Points numbers(numbers_.rows(), 3);
    numbers.topRows(pose.numbers.rows()) = pose.numbers;
    if (free_.count() > 0)
    {
        const std::vector<Vector3> none;
        const auto turns =
            free_.turn({input_.part, targets, none}, narrow_product(turning_, pose.numbers),
                       frame.bodies, frame.free);
        if (!turns)
            return std::nullopt;
        numbers.bottomRows(free_.count()) = *turns;
    }
    frame.coefficients = narrow_product(blend_, numbers);
    const Points missed = narrow_product(numbers_, frame.coefficients) - numbers;
    if (!(missed.cwiseAbs().maxCoeff() <= largest_miss))
        return std::nullopt;
    frame.handles = targets.handles;
    for (const PropagatedTarget& target : targets.propagated)
        frame.regions.push_back(target.positions);
    shift_bodies(frame);
    blend_logs(frame);
    frame.features = feature_motions(input_.part, frame.bodies);
    return frame;
}

void SampledResponse::place_reads(const Frame& frame, Deformation& result) const
{
    const Points& rest = input_.part.rest.points();
    result.positions.resize(rest.rows(), 3);
    result.rotation_logs.resize(rest.rows(), 3);
    const Points moved = narrow_product(reads_rows_, frame.coefficients);
    const auto open = static_cast<Eigen::Index>(open_.size());
    for (Eigen::Index k = open; k < open + reads_; ++k)
    {
        const int vertex = watched_[at(k)];
        result.positions.row(vertex) = rest.row(vertex) + moved.row(k);
        result.rotation_logs.row(vertex) = frame.logs.row(k);
    }
    result.features = frame.features;
}

void SampledResponse::place(const Frame& frame, Deformation& result) const
{
    basis_.add_to(input_.part.rest.points(), frame.coefficients, result.positions);
    for (const Group& group : groups_)
    {
        const RigidMotion& motion = group.body >= 0 ? frame.bodies.motions[at(group.body)]
                                                    : frame.handles[at(group.handle)];
        const Points moved = motion.apply(group.rest);
        for (std::size_t k = 0; k < group.vertices.size(); ++k)
            result.positions.row(group.vertices[k]) = moved.row(static_cast<Eigen::Index>(k));
    }
    for (const Known& known : known_)
        result.positions.row(known.vertex) = frame.regions[at(known.region)].row(known.row);
    result.rotation_logs.resize(0, 3);
    result.features = frame.features;
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/response.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/surface/features/reduced_minimum.h"
#include "sheetmorph/surface/features/turner_field.h"
#include "sheetmorph/surface/live/learning.h"

#include <Eigen/QR>
#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// Limit on the vertices of contacts. Chosen, not measured: every snapshot prescribes all of them,
// so the set-up grows with their number.
constexpr std::size_t most_propagated = 5000;

// Largest error of a frame's numbers as a combination of the snapshots, about radians. From the
// accuracy of a frame, 1e-6 of the size (Exactness): radians become lengths up to the size, and a
// quarter to a half of the limit goes here.
constexpr double largest_miss = 4e-7;

// Error of the fields per unit of a number, relative to the part's size. From the accuracy of a
// frame, 1e-6: up to 50 numbers of about 1 add up to it in the worst case.
constexpr double miss_a_size = 2e-8;

// Fields converted between two checks for cancellation.
constexpr Eigen::Index fields_at_once = 24;  // chosen, not measured

// Radians. From Newton's method: the error is of the order of the last step squared (at most ten
// times, reduced_minimum.cpp), hence below 1e-9.
constexpr double live_precision = 1e-5;

// Bound on the difference of logs around a body (turner_field.h) below which nothing constrains it.
// From turner_field.cpp: constraints begin at 75 degrees. Logs are half angles, 0.65 radians there.
constexpr double surely_not_held = 0.6;

double largest(const Points& numbers)
{
    return numbers.size() == 0 ? 0.0 : numbers.cwiseAbs().maxCoeff();
}

}  // namespace

bool Response::Frame::has_sizes() const
{
    return std::any_of(sizes.begin(), sizes.end(),
                       [](const auto& size) { return size.has_value(); });
}

bool Response::is_possible(const PreparedSurface& part)
{
    std::size_t propagated = 0;
    for (const KnownRegion& region : part.constraints.propagated)
        propagated += region.vertices.size();
    return propagated <= most_propagated;
}

Response::Response(const PreparedSurface& part, const std::vector<SurfaceTargets>& samples,
                   ResponseReaders readers, const Progress& progress)
    : part_(part), readers_(std::move(readers))
{
    find_known();
    learn(samples, progress);
}

bool Response::wants_all_logs() const
{
    const auto is_shape = [](const std::optional<forms::FeatureShape>& shape)
    { return shape.has_value(); };
    return readers_.all_logs || std::any_of(part_.shapes.begin(), part_.shapes.end(), is_shape);
}

void Response::find_known()
{
    const VertexRoles& roles = part_.roles;
    const std::size_t handles = part_.constraints.handles.size();
    groups_.resize(handles + roles.bodies.size());
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        if (roles.role[i] == Role::handle || roles.role[i] == Role::body)
            groups_[at(roles.owner[i]) + (roles.role[i] == Role::body ? handles : 0)]
                .vertices.push_back(static_cast<int>(i));
    for (std::size_t k = 0; k < groups_.size(); ++k)
    {
        groups_[k].handle = k < handles ? static_cast<int>(k) : -1;
        groups_[k].body = k < handles ? -1 : static_cast<int>(k - handles);
        groups_[k].rest = part_.rest.points()(groups_[k].vertices, Eigen::indexing::all);
    }
    const std::vector<KnownRegion>& regions = part_.constraints.propagated;
    for (std::size_t region = 0; region < regions.size(); ++region)
        for (std::size_t k = 0; k < regions[region].vertices.size(); ++k)
            if (roles.role[at(regions[region].vertices[k])] == Role::propagated)
                known_.push_back(
                    {regions[region].vertices[k], static_cast<int>(region), static_cast<int>(k)});
    for (std::size_t k = 0; k < roles.bodies.size(); ++k)
        if (roles.bodies[k].is_open())
            open_.push_back(static_cast<int>(k));
}

// Collects the rotating bodies that influence each read vertex, with their weights.
void Response::find_blends()
{
    if (part_.responses == nullptr)
        return;
    for (std::size_t row = 0; row < readers_.vertices.size(); ++row)
        for (auto entry = part_.responses->weights().at_vertex(readers_.vertices[row]); entry;
             ++entry)
            blends_.push_back({static_cast<Eigen::Index>(row), entry.col(), entry.value()});
}

void Response::find_spread()
{
    if (part_.responses == nullptr)
        return;
    const SmoothWeights& weights = part_.responses->weights();
    const numerics::Weights& field = numbers_->field();
    spread_ = Eigen::MatrixXd::Zero(weights.groups(), field.cols());
    for (Eigen::Index i = 0; i < weights.vertices(); ++i)
        for (auto entry = weights.at_vertex(i); entry; ++entry)
        {
            const int own = part_.responses->turners()[at(entry.col())].vertices.front();
            auto spread = spread_.row(entry.col());
            spread = spread.cwiseMax((field.row(i) - field.row(own)).cwiseAbs());
        }
}

void Response::learn(const std::vector<SurfaceTargets>& samples, const Progress& progress)
{
    std::vector<KnownPose> poses;
    for (const SurfaceTargets& targets : samples)
        poses.emplace_back(part_, targets);
    numbers_.emplace(part_, poses);
    const Span span = spanned(learnt_columns(*numbers_, poses));
    is_learnt_ = span.miss <= largest_miss
                 && (part_.responses == nullptr || part_.responses->fields(progress) != nullptr);
    if (!is_learnt_)
        return;
    find_spread();
    merge_into(readers_.vertices, part_.followers.corners());
    find_blends();
    const Eigen::MatrixXd fields = solve(poses, span, progress);
    tell_from_few(span);
    keep(fields, span.reach, progress);
}

// (n, k) displacement fields for the directions of the span.
Eigen::MatrixXd Response::solve(const std::vector<KnownPose>& poses, const Span& span,
                                const Progress& progress)
{
    const LearntFields learning(part_, *numbers_, poses);
    Eigen::MatrixXd slopes;
    Eigen::MatrixXd answers = learning.solve(span.chosen, slopes, progress);
    span.upper.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(answers);
    if (slopes.size() > 0)
        span.upper.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(slopes);
    slopes_ = std::move(slopes);
    return answers;
}

// Selects the interpolation points: numbers within the span are determined by the movers and some
// of the places, and a frame only evaluates these. All movers stay, to detect a motion that no
// sample contains.
void Response::tell_from_few(const Span& span)
{
    const std::vector<int> items = numbers_->items();
    std::vector<int> kept = numbers_->movers();
    for (const Eigen::Index row : telling_rows(span.directions))
        kept.push_back(items[at(row)]);
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    std::vector<Eigen::Index> rows;
    for (std::size_t row = 0; row < items.size(); ++row)
        if (std::binary_search(kept.begin(), kept.end(), items[row]))
            rows.push_back(static_cast<Eigen::Index>(row));
    told_ = span.directions(rows, Eigen::indexing::all);
    blend_.resize(told_.cols(), told_.rows());
    if (!span.chosen.empty())
        blend_ = Eigen::MatrixXd(told_).householderQr().solve(
            Eigen::MatrixXd::Identity(told_.rows(), told_.rows()));
    if (wants_all_logs() || part_.responses != nullptr)
        return numbers_->keep(kept);
    VertexIds wanted = readers_.vertices;
    for (const Body& body : part_.roles.bodies)
        wanted.push_back(body.vertices.front());
    numbers_->keep(kept, std::move(wanted));
}

// Stores the fields; those of rotating bodies come first.
void Response::keep(const Eigen::MatrixXd& fields, const Eigen::VectorXd& reach,
                    const Progress& progress)
{
    numerics::ResponseFields all =
        part_.responses != nullptr ? *part_.responses->fields()
                                   : numerics::ResponseFields(part_.rest.points(), fields.cols());
    const Eigen::Index own = all.columns();
    reads_rows_.resize(static_cast<Eigen::Index>(open_.size() + readers_.vertices.size()),
                       own + fields.cols());
    for (Eigen::Index row = 0; row < reads_rows_.rows(); ++row)
    {
        const bool is_open = at(row) < open_.size();
        const int vertex = is_open ? part_.roles.bodies[at(open_[at(row)])].vertices.front()
                                   : readers_.vertices[at(row) - open_.size()];
        reads_rows_.row(row) << all.row(vertex), fields.row(vertex);
    }
    const Eigen::VectorXd tolerances = miss_a_size * part_.rest.size() * reach.cwiseInverse();
    for (Eigen::Index first = 0; first < fields.cols(); first += fields_at_once)
    {
        progress.report(static_cast<double>(first) / static_cast<double>(fields.cols()),
                        "laying out the response");
        const Eigen::Index count = std::min(fields_at_once, fields.cols() - first);
        all.append(fields.middleCols(first, count), tolerances.segment(first, count));
    }
    basis_ = numerics::ResponseBasis(all);
}

// Bodies start with the rotation of the field.
void Response::turn_open(const PoseNumbers::Turns& turns, BodyMotions& bodies) const
{
    for (std::size_t k = 0; k < part_.roles.bodies.size(); ++k)
    {
        const Body& body = part_.roles.bodies[k];
        if (body.is_known())
            continue;
        const auto weights = numbers_->field().row(numbers_->row_of(body.vertices.front()));
        const Vector3 log = (weights * turns.logs).transpose();
        Vector3& turned = bodies.motions[k].rotation_log;
        turned = log;
        if (turns.tilts.rows() == 0)
            continue;
        if (const Vector3 tilt = (weights * turns.tilts).transpose(); !tilt.isZero(0.0))
            turned = nearest_branch(log_from_rotation(tilted_rotation(log, tilt)), log);
    }
}

// Uses a bound if it is below the angle at which constraints begin; otherwise computes exactly.
std::vector<double> Response::farthest(const PoseNumbers::Turns& turns) const
{
    const Eigen::VectorXd bounds = spread_ * turns.logs.rowwise().norm();
    if (bounds.size() == 0 || bounds.maxCoeff() < surely_not_held)
        return {bounds.data(), bounds.data() + bounds.size()};
    return farthest_turns(*part_.responses,
                          numerics::narrow_product(numbers_->field(), turns.logs));
}

// \returns coordinates of the rotating bodies' own fields; nothing if Newton's method does not
//          converge
std::optional<Points> Response::minimise_turned(const SurfaceTargets& targets, const Points& blend,
                                                Frame& frame) const
{
    if (part_.responses == nullptr)
        return Points(0, 3);
    const FeatureResponses& responses = *part_.responses;
    const PlacementInput placement = part_.placement();
    ReducedEnergy energy{responses.stiffness(), numerics::narrow_product(slopes_, blend)};
    Joints joints(placement, targets, responses.turners(), frame.bodies);
    hold_far_turned(responses, farthest(frame.turns), joints, energy);
    if (!minimise(joints, {placement, responses, energy}, live_precision).is_converged)
        return std::nullopt;
    frame.turned = joints.states();
    for (std::size_t k = 0; k < frame.turned.size(); ++k)
        if (const int body = responses.turners()[k].body; body >= 0)
        {
            RigidMotion& motion = frame.bodies.motions[at(body)];
            motion = motion_of(part_.roles.bodies[at(body)], frame.turned[k], motion.rotation_log);
        }
    return Points(entries_of(joints, placement, responses));
}

// Translates bodies with the sheet.
void Response::shift_bodies(Frame& frame) const
{
    const Points moved = numerics::narrow_product(
        reads_rows_.topRows(static_cast<Eigen::Index>(open_.size())), frame.coefficients);
    for (std::size_t k = 0; k < open_.size(); ++k)
    {
        const int first = part_.roles.bodies[at(open_[k])].vertices.front();
        const Vector3 start = part_.rest.points().row(first).transpose();
        RigidMotion& motion = frame.bodies.motions[at(open_[k])];
        motion.translation.setZero();
        motion.translation =
            moved.row(static_cast<Eigen::Index>(k)).transpose() - (motion.apply(start) - start);
    }
}

// The rotation of the sheet at read vertices (blend_logs() for some vertices).
void Response::blend_logs(Frame& frame) const
{
    frame.logs.resize(static_cast<Eigen::Index>(readers_.vertices.size()), 3);
    for (std::size_t k = 0; k < readers_.vertices.size(); ++k)
        frame.logs.row(static_cast<Eigen::Index>(k)) =
            numbers_->field().row(numbers_->row_of(readers_.vertices[k])) * frame.turns.logs;
    const Points field = frame.logs;
    std::vector<Vector3> logs;
    for (std::size_t k = 0; k < frame.turned.size() && !blends_.empty(); ++k)
    {
        const int own = part_.responses->turners()[k].vertices.front();
        logs.push_back(log_near(
            frame.turned[k].rotation,
            (numbers_->field().row(numbers_->row_of(own)) * frame.turns.logs).transpose()));
    }
    for (const Blend& blend : blends_)
        frame.logs.row(blend.row) +=
            blend.weight * (logs[at(blend.turner)].transpose() - field.row(blend.row));
}

std::optional<Response::Frame> Response::frame(const SurfaceTargets& targets) const
{
    if (!is_learnt_)
        return std::nullopt;
    const KnownPose pose(part_, targets);
    if (part_.far_turns && part_.far_turns->are_there(targets, pose.bodies))
        return std::nullopt;
    Frame frame;
    frame.turns = numbers_->turns(pose);
    const Points numbers = numbers_->of(pose, frame.turns);
    const Points blend = numerics::narrow_product(blend_, numbers);
    const Points missed = numerics::narrow_product(told_, blend) - numbers;
    if (!(frame.turns.miss <= largest_miss && largest(missed) <= largest_miss))
        return std::nullopt;
    frame.sizes = size_changes(part_.constraints, part_.shapes, targets);
    frame.handles = targets.handles;
    for (const PropagatedTarget& target : targets.propagated)
        frame.regions.push_back(target.positions);
    frame.bodies = pose.bodies;
    turn_open(frame.turns, frame.bodies);
    const std::optional<Points> turned = minimise_turned(targets, blend, frame);
    if (!turned)
        return std::nullopt;
    frame.coefficients.resize(turned->rows() + blend.rows(), 3);
    frame.coefficients << *turned, blend;
    shift_bodies(frame);
    blend_logs(frame);
    frame.features = feature_motions(part_.placement(), frame.bodies);
    return frame;
}

void Response::place_reads(const Frame& frame, Deformation& result) const
{
    const Points& rest = part_.rest.points();
    result.positions.resize(rest.rows(), 3);
    result.rotation_logs.resize(rest.rows(), 3);
    const auto open = static_cast<Eigen::Index>(open_.size());
    const Points moved = numerics::narrow_product(reads_rows_.bottomRows(reads_rows_.rows() - open),
                                                  frame.coefficients);
    for (Eigen::Index k = 0; k < moved.rows(); ++k)
    {
        const int vertex = readers_.vertices[at(k)];
        result.positions.row(vertex) = rest.row(vertex) + moved.row(k);
        result.rotation_logs.row(vertex) = frame.logs.row(k);
    }
    part_.followers.place(part_.rest, result.positions, result.rotation_logs);
    result.features = frame.features;
}

void Response::fill_logs(const Frame& frame, Deformation& result) const
{
    const bool is_read = wants_all_logs() || !readers_.vertices.empty();
    result.rotation_logs.resize(is_read ? part_.rest.vertex_count() : 0, 3);
    if (wants_all_logs())
    {
        result.rotation_logs = numerics::narrow_product(numbers_->field(), frame.turns.logs);
        if (part_.responses != nullptr)
            surface::blend_logs(*part_.responses, frame.turned, result.rotation_logs);
    }
    else if (is_read)
        for (std::size_t k = 0; k < readers_.vertices.size(); ++k)
            result.rotation_logs.row(readers_.vertices[k]) =
                frame.logs.row(static_cast<Eigen::Index>(k));
}

void Response::place(const Frame& frame, Deformation& result) const
{
    basis_.add_to(part_.rest.points(), frame.coefficients, result.positions);
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
    fill_logs(frame, result);
    result.features = frame.features;
    if (frame.has_sizes())
        part_.growth.lay(frame.sizes, result);
    part_.followers.place(part_.rest, result.positions, result.rotation_logs);
}

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/sampled_response.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/live/sampled_span.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// Contacts of more vertices together take too long to prepare.
constexpr std::size_t most_propagated = 1000;

// Columns that are substituted together, about.
constexpr Eigen::Index together = 12;

// By how much the fields may miss what a number moves, of the part's size.
constexpr double miss_a_size = 2e-8;

// The vertices around a free feature that are watched.
constexpr Eigen::Index watched_around = 8;

// The numbers of all samples, three columns each.
template <typename Samples>
Eigen::MatrixXd columns_of(const Samples& samples)
{
    Eigen::MatrixXd columns(samples.front().numbers.rows(),
                            3 * static_cast<Eigen::Index>(samples.size()));
    for (std::size_t k = 0; k < samples.size(); ++k)
        columns.middleCols(3 * static_cast<Eigen::Index>(k), 3) = samples[k].numbers;
    return columns;
}

}  // namespace

bool SampledResponse::is_possible(const ResponseInput& input)
{
    const SurfaceConstraints& constraints = input.part.constraints;
    std::size_t propagated = 0;
    for (const KnownRegion& region : constraints.propagated)
        propagated += region.vertices.size();
    const std::vector<Body>& bodies = input.part.roles.bodies;
    const auto is_plain = [](const Body& body) { return !body.is_bound && body.handle < 0; };
    return propagated + constraints.handles.size() > 0 && propagated <= most_propagated
           && constraints.points.empty() && constraints.links.empty() && input.followers.is_empty()
           && std::all_of(bodies.begin(), bodies.end(), is_plain)
           && FreeFields::is_possible(input.part, input.free_features);
}

SampledResponse::SampledResponse(const ResponseInput& input,
                                 const std::vector<SurfaceTargets>& samples, const VertexIds& reads,
                                 const Progress& progress)
    : input_(input),
      no_weights_(input.part.rest.vertex_count(), 0),
      free_(input.free_features, no_weights_),
      watched_(watched(reads)),
      drivers_(input_, watched_)
{
    find_known();
    std::vector<Sample> learnt = taken(samples);
    if (learnt.empty())
        return;
    if (free_.count() > 0)
        learn_turns(learnt, progress);
    learn(learnt, progress);
}

VertexIds SampledResponse::watched(const VertexIds& reads)
{
    VertexIds vertices;
    const std::vector<Body>& bodies = input_.part.roles.bodies;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (!bodies[k].is_known())
        {
            open_.push_back(static_cast<int>(k));
            vertices.push_back(bodies[k].vertices.front());
        }
    reads_ = static_cast<Eigen::Index>(reads.size());
    vertices.insert(vertices.end(), reads.begin(), reads.end());
    if (input_.free_features != nullptr)
        watch_turners(vertices);
    return vertices;
}

void SampledResponse::watch_turners(VertexIds& vertices)
{
    const FeatureResponses& responses = *input_.free_features;
    const auto open = static_cast<Eigen::Index>(open_.size());
    for (Eigen::Index k = 0; k < responses.weights().cols(); ++k)
    {
        VertexIds support;
        for (SparseMatrix::InnerIterator entry(responses.weights(), k); entry; ++entry)
        {
            support.push_back(static_cast<int>(entry.row()));
            for (Eigen::Index row = open; row < open + reads_; ++row)
                if (vertices[at(row)] == entry.row())
                    blends_.push_back({row, k, entry.value()});
        }
        around_.push_back({static_cast<Eigen::Index>(vertices.size()), 0});
        vertices.push_back(responses.turners()[at(k)].vertices.front());
        const std::size_t step = support.size() / at(watched_around) + 1;
        for (std::size_t i = 0; i < support.size(); i += step)
            vertices.push_back(support[i]);
        around_.back().count = static_cast<Eigen::Index>(vertices.size()) - around_.back().first;
    }
}

// What moves as it is told, or as one.
void SampledResponse::find_known()
{
    const VertexRoles& roles = input_.part.roles;
    const std::size_t handles = input_.part.constraints.handles.size();
    groups_.resize(handles + roles.bodies.size());
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        if (roles.role[i] == Role::handle || roles.role[i] == Role::body)
            groups_[at(roles.owner[i]) + (roles.role[i] == Role::body ? handles : 0)]
                .vertices.push_back(static_cast<int>(i));
    for (std::size_t k = 0; k < groups_.size(); ++k)
    {
        Group& group = groups_[k];
        group.handle = k < handles ? static_cast<int>(k) : -1;
        group.body = k < handles ? -1 : static_cast<int>(k - handles);
        group.rest.resize(static_cast<Eigen::Index>(group.vertices.size()), 3);
        for (std::size_t v = 0; v < group.vertices.size(); ++v)
            group.rest.row(static_cast<Eigen::Index>(v)) =
                input_.part.rest.points().row(group.vertices[v]);
    }
    const std::vector<KnownRegion>& regions = input_.part.constraints.propagated;
    for (std::size_t region = 0; region < regions.size(); ++region)
        for (std::size_t k = 0; k < regions[region].vertices.size(); ++k)
            if (roles.role[at(regions[region].vertices[k])] == Role::propagated)
                known_.push_back(
                    {regions[region].vertices[k], static_cast<int>(region), static_cast<int>(k)});
}

// Those poses in which no free feature would be held, free features not yet turned.
std::vector<SampledResponse::Sample> SampledResponse::taken(
    const std::vector<SurfaceTargets>& samples) const
{
    std::vector<Sample> result;
    for (const SurfaceTargets& targets : samples)
    {
        Sample sample{&targets, {}, {}, known_body_motions(input_.part, targets), {}};
        const DriverNumbers::Pose pose = drivers_.of(targets, sample.bodies);
        if (is_far_turned(pose.logs))
            continue;
        sample.numbers = pose.numbers;
        sample.logs = open_logs(pose);
        for (std::size_t k = 0; k < open_.size(); ++k)
            if (!free_.turns(open_[k]))
                sample.bodies.motions[at(open_[k])].rotation_log =
                    sample.logs.row(static_cast<Eigen::Index>(k)).transpose();
        result.push_back(std::move(sample));
    }
    return result;
}

// The whole right-hand side of a pose.
ConstrainedMinimiser::Targets SampledResponse::asked(const Sample& sample) const
{
    const PlacementInput& part = input_.part;
    const GivenRotations given = given_rotations(part, *sample.targets, sample.bodies);
    const Points logs = input_.field.logs(given.logs);
    const Points tilts =
        given.is_tilted ? input_.field.logs(given.tilts) : Points(Points::Zero(logs.rows(), 3));
    std::vector<Matrix3> turns(at(logs.rows()));
    for (Eigen::Index i = 0; i < logs.rows(); ++i)
        turns[at(i)] = free_.left(static_cast<int>(i))
                       * (tilted_rotation(logs.row(i).transpose(), tilts.row(i).transpose())
                          - Matrix3::Identity());
    for (std::size_t k = 0; k < sample.free.size(); ++k)
        for (SparseMatrix::InnerIterator entry(input_.free_features->weights(),
                                               static_cast<Eigen::Index>(k));
             entry; ++entry)
            turns[at(entry.row())] +=
                entry.value() * (sample.free[k].rotation - Matrix3::Identity());
    ConstrainedMinimiser::Targets result;
    result.offset = known_displacements(part, *sample.targets, sample.bodies);
    result.constraints.resize(0, 3);
    result.rows.resize(input_.operators.rest_rows.rows(), 3);
    for (Eigen::Index row = 0; row < result.rows.rows(); ++row)
        result.rows.row(row) = (turns[at(input_.operators.row_vertices[at(row)])]
                                * input_.operators.rest_rows.row(row).transpose())
                                   .transpose();
    return result;
}

// (n, k): how the sheet answers the span's columns. Without free turns free_ takes them in, in
// their order.
Eigen::MatrixXd SampledResponse::solve(const std::vector<Sample>& samples, const SampledSpan& span,
                                       const Progress& progress)
{
    const auto count = static_cast<Eigen::Index>(span.chosen.size());
    const bool is_turned = !samples.front().free.empty();
    Eigen::MatrixXd answers(input_.part.rest.vertex_count(), count);
    for (Eigen::Index first = 0; first < count; first += together)
    {
        progress.report(static_cast<double>(first) / static_cast<double>(count), "response fields");
        const Eigen::Index width = std::min(together, count - first);
        ConstrainedMinimiser::Targets targets;
        targets.rows.resize(input_.operators.rest_rows.rows(), width);
        targets.offset.resize(answers.rows(), width);
        targets.constraints.resize(0, width);
        for (Eigen::Index k = 0; k < width; ++k)
        {
            const Eigen::Index chosen = span.chosen[at(first + k)];
            const ConstrainedMinimiser::Targets pose = asked(samples[at(chosen / 3)]);
            targets.rows.col(k) = pose.rows.col(chosen % 3);
            targets.offset.col(k) = pose.offset.col(chosen % 3);
        }
        const ConstrainedMinimiser::Solution answer =
            input_.minimiser.minimum(targets, free_.count() > 0 ? 1 : 0);
        if (!is_turned)
            free_.append(targets, answer);
        answers.middleCols(first, width) = answer.u;
    }
    return answers;
}

// How free features turn, first for all poses of the span, then in every sample.
void SampledResponse::learn_turns(std::vector<Sample>& samples, const Progress& progress)
{
    const SampledSpan span = spanned(columns_of(samples));
    solve(samples, span, progress);
    turning_ = span.upper.triangularView<Eigen::Upper>().solve(span.directions.transpose());
    for (Sample& sample : samples)
    {
        for (std::size_t k = 0; k < open_.size(); ++k)
            sample.bodies.motions[at(open_[k])].rotation_log =
                sample.logs.row(static_cast<Eigen::Index>(k)).transpose();
        const std::vector<Vector3> none;
        const FreeFields::Pose pose{input_.part, *sample.targets, none};
        const auto turns = free_.turn(pose, turning_ * sample.numbers, sample.bodies, sample.free);
        if (!turns)
            throw SolverError("the turns of form features do not settle in a pose to learn from");
        sample.numbers.conservativeResize(sample.numbers.rows() + turns->rows(), Eigen::NoChange);
        sample.numbers.bottomRows(turns->rows()) = *turns;
    }
}

void SampledResponse::learn(const std::vector<Sample>& samples, const Progress& progress)
{
    const SampledSpan span = spanned(columns_of(samples));
    Eigen::MatrixXd fields = solve(samples, span, progress);
    span.upper.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(fields);
    numbers_ = span.directions;
    blend_ = span.directions.transpose();
    ResponseFields all(fields.rows(), fields.cols());
    all.append(fields, miss_a_size * input_.part.rest.size() * span.reach.cwiseInverse());
    basis_ = ResponseBasis(all);
    reads_rows_.resize(static_cast<Eigen::Index>(open_.size()) + reads_, fields.cols());
    for (Eigen::Index row = 0; row < reads_rows_.rows(); ++row)
        reads_rows_.row(row) = fields.row(watched_[at(row)]);
}

}  // namespace sheetmorph

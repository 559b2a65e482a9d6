// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/surface_response.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/operators/point_rows.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// Polynomials that are substituted together: three columns each.
constexpr Eigen::Index together = 4;

// By how much the basis may miss what a polynomial moves, of the part's size; or a shift by one.
constexpr double miss_a_size = 2e-8;

SurfaceTargets no_motion(const SurfaceConstraints& constraints)
{
    SurfaceTargets targets;
    targets.handles.resize(constraints.handles.size());
    targets.feature_logs.assign(constraints.features.size(), Vector3::Zero());
    targets.points.resize(constraints.points.size());
    return targets;
}

// The field is linear in the logs it is given, so a turn of one is its weights.
Eigen::MatrixXd weights_of(const ResponseInput& input, const std::vector<int>& turning)
{
    Eigen::MatrixXd weights(input.part.rest.vertex_count(),
                            static_cast<Eigen::Index>(turning.size()));
    for (std::size_t s = 0; s < turning.size(); ++s)
    {
        SurfaceTargets targets = no_motion(input.part.constraints);
        targets.handles[at(turning[s])].rotation_log = Vector3::UnitX();
        const BodyMotions bodies = known_body_motions(input.part, targets);
        const GivenRotations given = given_rotations(input.part, targets, bodies);
        weights.col(static_cast<Eigen::Index>(s)) = input.field.logs(given.logs).col(0);
    }
    return weights;
}

// Of the three columns of every polynomial: what counts little may be missed by more.
Eigen::VectorXd tolerances(const RotationSeries& series, double size)
{
    const Eigen::MatrixXd inverse = series.reach().cwiseInverse().transpose().replicate(3, 1);
    return miss_a_size * size * inverse.reshaped();
}

Vector3 centroid(const Points& points)
{
    return points.rows() == 0 ? Vector3(Vector3::Zero())
                              : Vector3(points.colwise().mean().transpose());
}

}  // namespace

bool SurfaceResponse::is_possible(const ResponseInput& input)
{
    return input.part.constraints.propagated.empty()
           && FreeFields::is_possible(input.part, input.free_features);
}

SurfaceResponse::SurfaceResponse(const ResponseInput& input, ResponseOptions options,
                                 const Progress& progress)
    : input_(input),
      options_(std::move(options)),
      shifting_(options_.turning),
      weights_(weights_of(input_, options_.turning)),
      series_(weights_, options_.degree),
      free_(input_.free_features, weights_),
      basis_(ResponseFields())
{
    shifting_.insert(shifting_.end(), options_.moving.begin(), options_.moving.end());
    find_groups();
    respond(progress);
}

// Handles and bodies that move as they are told, or as one; each with its
// vertices at rest.
void SurfaceResponse::find_groups()
{
    const VertexRoles& roles = input_.part.roles;
    const std::size_t handles = input_.part.constraints.handles.size();
    groups_.resize(handles + roles.bodies.size());
    for (std::size_t k = 0; k < groups_.size(); ++k)
    {
        const bool is_handle = k < handles;
        groups_[k].handle = is_handle ? static_cast<int>(k) : -1;
        groups_[k].body = is_handle ? -1 : static_cast<int>(k - handles);
        if (!is_handle && roles.bodies[k - handles].motion == Body::Motion::handle)
            groups_[k].handle = roles.bodies[k - handles].driver;
    }
    for (std::size_t i = 0; i < roles.role.size(); ++i)
    {
        const bool is_handle = roles.role[i] == Role::handle;
        if (is_handle || roles.role[i] == Role::body)
            groups_[at(roles.owner[i]) + (is_handle ? 0 : handles)].vertices.push_back(
                static_cast<int>(i));
    }
    for (Group& group : groups_)
    {
        group.rest.resize(static_cast<Eigen::Index>(group.vertices.size()), 3);
        for (std::size_t k = 0; k < group.vertices.size(); ++k)
            group.rest.row(static_cast<Eigen::Index>(k)) =
                input_.part.rest.points().row(group.vertices[k]);
    }
    // A body that a handle carries turns about the handle's centre.
    for (Group& group : groups_)
    {
        group.centre = group.handle >= 0 ? centroid(groups_[at(group.handle)].rest)
                                         : roles.bodies[at(group.body)].centre;
    }
}

// Arms of rigid vertices about their centre, and where each shift acts.
SurfaceResponse::Rigid SurfaceResponse::rigid_fields() const
{
    const Eigen::Index n = input_.part.rest.vertex_count();
    Rigid fields{Eigen::MatrixXd::Zero(n, 3),
                 Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(shifting_.size()))};
    for (const Group& group : groups_)
    {
        const auto shifting = std::find(shifting_.begin(), shifting_.end(), group.handle);
        const bool is_free = group.body >= 0 && free_.turns(group.body);
        for (const int vertex : group.vertices)
        {
            if (!is_free)
                fields.arms.row(vertex) =
                    input_.part.rest.points().row(vertex) - group.centre.transpose();
            if (shifting != shifting_.end())
                fields.shifts(vertex, shifting - shifting_.begin()) = 1.0;
        }
    }
    for (const Clamp& clamp : input_.part.roles.clamps)
        for (const Clamp::Carrier& carrier : clamp.carriers)
            fields.shifts.row(clamp.vertex) += carrier.weight * fields.shifts.row(carrier.vertex);
    return fields;
}

// Clamped vertices turn with the handles that carry them, about their centres.
void SurfaceResponse::add_clamped(const Eigen::MatrixXd& values, Eigen::MatrixXd& offset) const
{
    const VertexRoles& roles = input_.part.roles;
    for (const Clamp& clamp : roles.clamps)
        for (const Clamp::Carrier& carrier : clamp.carriers)
        {
            if (roles.role[at(carrier.vertex)] != Role::handle)
                continue;
            const Vector3& centre = groups_[at(roles.owner[at(carrier.vertex)])].centre;
            const Eigen::RowVector3d arm =
                input_.part.rest.points().row(clamp.vertex) - centre.transpose();
            for (Eigen::Index k = 0; k < values.cols(); ++k)
                offset.row(clamp.vertex).segment(3 * k, 3) +=
                    carrier.weight * values(carrier.vertex, k) * arm;
        }
}

// Fields of q_k D p_hat: what is rigid turns about its centre likewise. Then shifts and points.
void SurfaceResponse::respond(const Progress& progress)
{
    const SurfaceOperators& operators = input_.operators;
    const Eigen::Index rows = operators.rest_rows.rows();
    const auto points = static_cast<Eigen::Index>(input_.part.constraints.points.size());
    const Rigid rigid = rigid_fields();
    const Eigen::VectorXd allowed = tolerances(series_, input_.part.rest.size());
    ResponseFields fields = free_.fields(input_.part.rest.vertex_count(), 3 * series_.count());
    first_ = fields.columns();
    const Eigen::MatrixXd values = series_.values(weights_);
    for (Eigen::Index first = 0; first < series_.count(); first += together)
    {
        progress.report(static_cast<double>(first) / series_.count(), "response fields");
        const Eigen::Index count = std::min<Eigen::Index>(together, series_.count() - first);
        ConstrainedMinimiser::Targets targets;
        targets.rows.resize(rows, 3 * count);
        targets.offset.resize(rigid.arms.rows(), 3 * count);
        targets.constraints = Eigen::MatrixXd::Zero(points, 3 * count);
        for (Eigen::Index k = 0; k < count; ++k)
        {
            for (Eigen::Index row = 0; row < rows; ++row)
                targets.rows.row(row).segment(3 * k, 3) =
                    values(operators.row_vertices[at(row)], first + k)
                    * free_.left(operators.row_vertices[at(row)]) * operators.rest_rows.row(row);
            targets.offset.middleCols(3 * k, 3) = values.col(first + k).asDiagonal() * rigid.arms;
        }
        add_clamped(values.middleCols(first, count), targets.offset);
        take(targets, allowed.segment(3 * first, 3 * count), fields);
    }
    const Eigen::Index shifts = rigid.shifts.cols();
    ConstrainedMinimiser::Targets targets;
    targets.rows = Eigen::MatrixXd::Zero(rows, shifts + points);
    targets.offset = Eigen::MatrixXd::Zero(rigid.arms.rows(), shifts + points);
    targets.offset.leftCols(shifts) = rigid.shifts;
    targets.constraints = Eigen::MatrixXd::Zero(points, shifts + points);
    targets.constraints.rightCols(points).setIdentity();
    take(targets, Eigen::VectorXd::Constant(shifts + points, miss_a_size), fields);
    basis_ = ResponseBasis(fields);
}

void SurfaceResponse::take(const ConstrainedMinimiser::Targets& asked,
                           const Eigen::VectorXd& tolerances, ResponseFields& fields)
{
    const ConstrainedMinimiser::Solution answer =
        input_.minimiser.minimum(asked, free_.count() > 0 ? 1 : 0);
    fields.append(answer.u, tolerances);
    free_.append(asked, answer);
}

}  // namespace sheetmorph

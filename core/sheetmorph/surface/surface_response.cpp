// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/surface_response.h"

#include "sheetmorph/surface/point_rows.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// By how much the polynomials may miss an entry of a rotation matrix.
constexpr double largest_miss = 4e-7;

// Polynomials that are substituted together: three columns each.
constexpr Eigen::Index together = 4;

std::size_t at(Eigen::Index index)
{
    return static_cast<std::size_t>(index);
}

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

Vector3 centroid(const Points& points)
{
    return points.rows() == 0 ? Vector3(Vector3::Zero())
                              : Vector3(points.colwise().mean().transpose());
}

std::vector<int> joined(std::vector<int> first, const std::vector<int>& second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

}  // namespace

bool SurfaceResponse::is_possible(const SurfaceConstraints& constraints)
{
    return constraints.propagated.empty();
}

SurfaceResponse::SurfaceResponse(const ResponseInput& input, ResponseOptions options,
                                 const Progress& progress)
    : input_(input),
      options_(std::move(options)),
      shifting_(joined(options_.turning, options_.moving)),
      weights_(weights_of(input_, options_.turning)),
      series_(weights_, options_.degree),
      basis_(
          input_.part.rest.vertex_count(),
          3 * series_.count()
              + static_cast<Eigen::Index>(shifting_.size() + input_.part.constraints.points.size()))
{
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
    const Eigen::Index n = basis_.rows();
    Rigid fields{Eigen::MatrixXd::Zero(n, 3),
                 Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(shifting_.size()))};
    for (const Group& group : groups_)
    {
        const auto shifting = std::find(shifting_.begin(), shifting_.end(), group.handle);
        for (const int vertex : group.vertices)
        {
            fields.arms.row(vertex) =
                input_.part.rest.points().row(vertex) - group.centre.transpose();
            if (shifting != shifting_.end())
                fields.shifts(vertex, shifting - shifting_.begin()) = 1.0;
        }
    }
    return fields;
}

// The columns of q_k D p_hat, three a polynomial: what is rigid turns about its
// centre likewise. Then one column for the shift of each moving handle and one
// for each point.
void SurfaceResponse::respond(const Progress& progress)
{
    const SurfaceOperators& operators = input_.operators;
    const Eigen::Index rows = operators.rest_rows.rows();
    const auto points = static_cast<Eigen::Index>(input_.part.constraints.points.size());
    const Rigid rigid = rigid_fields();
    const Eigen::MatrixXd values = series_.values(weights_);
    for (Eigen::Index first = 0; first < series_.count(); first += together)
    {
        progress.report(static_cast<double>(first) / series_.count(), "response fields");
        const Eigen::Index count = std::min<Eigen::Index>(together, series_.count() - first);
        ConstrainedMinimiser::Targets targets;
        targets.rows.resize(rows, 3 * count);
        targets.offset.resize(basis_.rows(), 3 * count);
        targets.constraints = Eigen::MatrixXd::Zero(points, 3 * count);
        for (Eigen::Index k = 0; k < count; ++k)
        {
            for (Eigen::Index row = 0; row < rows; ++row)
                targets.rows.row(row).segment(3 * k, 3) =
                    values(operators.row_vertices[at(row)], first + k)
                    * operators.rest_rows.row(row);
            targets.offset.middleCols(3 * k, 3) = values.col(first + k).asDiagonal() * rigid.arms;
        }
        basis_.set_columns(3 * first, input_.minimiser.solve(targets, 0));
    }
    const Eigen::Index shifts = rigid.shifts.cols();
    ConstrainedMinimiser::Targets targets;
    targets.rows = Eigen::MatrixXd::Zero(rows, shifts + points);
    targets.offset = Eigen::MatrixXd::Zero(basis_.rows(), shifts + points);
    targets.offset.leftCols(shifts) = rigid.shifts;
    targets.constraints = Eigen::MatrixXd::Zero(points, shifts + points);
    targets.constraints.rightCols(points).setIdentity();
    basis_.set_columns(3 * series_.count(), input_.minimiser.solve(targets, 0));
}

bool SurfaceResponse::covers(const SurfaceTargets& targets) const
{
    const SurfaceConstraints& constraints = input_.part.constraints;
    const auto has = [](const std::vector<int>& list, std::size_t k)
    { return std::find(list.begin(), list.end(), static_cast<int>(k)) != list.end(); };
    const auto is_set = [](const std::optional<double>& size) { return size.has_value(); };
    bool is_covered = std::none_of(targets.sizes.begin(), targets.sizes.end(), is_set);
    for (std::size_t k = 0; k < targets.handles.size(); ++k)
    {
        const RigidMotion& motion = targets.handles[k];
        is_covered = is_covered && (has(options_.turning, k) || motion.rotation_log.isZero(0.0))
                     && (has(shifting_, k) || motion.translation.isZero(0.0));
    }
    for (std::size_t k = 0; k < constraints.features.size(); ++k)
        is_covered = is_covered
                     && !(constraints.features[k].rotation == FeatureRotation::prescribed
                          && !targets.feature_logs[k].isZero(0.0));
    for (std::size_t k = 0; k < constraints.points.size(); ++k)
        is_covered =
            is_covered
            && !(constraints.points[k].is_turned && !targets.points[k].rotation_log.isZero(0.0));
    return is_covered;
}

// Open bodies turn with the field and shift with the basis.
void SurfaceResponse::turn_bodies(Frame& frame) const
{
    for (const Group& group : groups_)
    {
        if (group.body < 0 || input_.part.roles.bodies[at(group.body)].is_known())
            continue;
        const int first = group.vertices.front();
        RigidMotion& motion = frame.bodies.motions[at(group.body)];
        if (input_.part.roles.bodies[at(group.body)].motion == Body::Motion::interpolated)
            for (std::size_t s = 0; s < frame.logs.size(); ++s)
                motion.rotation_log +=
                    weights_(first, static_cast<Eigen::Index>(s)) * frame.logs[s];
        const Vector3 start = input_.part.rest.points().row(first).transpose();
        motion.translation = basis_.row(first, frame.coefficients) - (motion.apply(start) - start);
    }
}

std::optional<SurfaceResponse::Frame> SurfaceResponse::frame(const SurfaceTargets& targets) const
{
    if (!covers(targets))
        return std::nullopt;
    Frame frame;
    for (const int handle : options_.turning)
        frame.logs.push_back(targets.handles[at(handle)].rotation_log);
    const RotationSeries::Fit fit = series_.fit(frame.logs);
    if (!(fit.error <= largest_miss))
        return std::nullopt;
    frame.coefficients.resize(basis_.columns(), 3);
    for (Eigen::Index k = 0; k < series_.count(); ++k)
        frame.coefficients.middleRows(3 * k, 3) = fit.matrices[at(k)].transpose().cast<float>();
    Eigen::Index row = 3 * series_.count();
    for (const int handle : shifting_)
    {
        const Vector3& centre = groups_[at(handle)].centre;
        const Vector3 shift = targets.handles[at(handle)].apply(centre) - centre;
        frame.coefficients.row(row++) = shift.transpose().cast<float>();
    }
    frame.coefficients.bottomRows(basis_.columns() - row) =
        point_displacements(input_.part.rest, input_.part.constraints.points, targets.points)
            .cast<float>();
    frame.handles = targets.handles;
    frame.bodies = known_body_motions(input_.part, targets);
    turn_bodies(frame);
    frame.features = feature_motions(input_.part, frame.bodies);
    return frame;
}

void SurfaceResponse::place(const Frame& frame, bool with_logs, Deformation& result) const
{
    const TriangleMesh& rest = input_.part.rest;
    basis_.add_to(rest.points(), frame.coefficients, result.positions);
    for (const Group& group : groups_)
    {
        const RigidMotion& motion = group.body >= 0 ? frame.bodies.motions[at(group.body)]
                                                    : frame.handles[at(group.handle)];
        const Points moved = motion.apply(group.rest);
        for (std::size_t k = 0; k < group.vertices.size(); ++k)
            result.positions.row(group.vertices[k]) = moved.row(static_cast<Eigen::Index>(k));
    }
    result.rotation_logs.resize(with_logs || !input_.followers.is_empty() ? rest.vertex_count() : 0,
                                3);
    if (result.rotation_logs.rows() != 0)
    {
        result.rotation_logs.setZero();
        for (std::size_t s = 0; s < frame.logs.size(); ++s)
            result.rotation_logs +=
                weights_.col(static_cast<Eigen::Index>(s)) * frame.logs[s].transpose();
        input_.followers.place(rest, result.positions, result.rotation_logs);
    }
    result.features = frame.features;
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/live/surface_response.h"
#include "sheetmorph/surface/operators/point_rows.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// By how much the polynomials may miss an entry of a rotation matrix.
constexpr double largest_miss = 4e-7;

}  // namespace

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
    // What no pose turns by itself has no log there.
    const auto turns = [](const Vector3& log) { return !log.isZero(0.0); };
    for (std::size_t k = 0; k < constraints.features.size(); ++k)
        if (constraints.features[k].rotation == FeatureRotation::prescribed)
            is_covered = is_covered && !turns(targets.feature_logs[k]);
    for (std::size_t k = 0; k < constraints.points.size(); ++k)
        if (constraints.points[k].is_turned)
            is_covered = is_covered && !turns(targets.points[k].rotation_log);
    return is_covered;
}

// Bodies start with the rotation of the field.
void SurfaceResponse::turn_bodies(Frame& frame) const
{
    for (const Group& group : groups_)
    {
        if (group.body < 0 || input_.part.roles.bodies[at(group.body)].is_known())
            continue;
        RigidMotion& motion = frame.bodies.motions[at(group.body)];
        if (input_.part.roles.bodies[at(group.body)].motion != Body::Motion::prescribed)
            for (std::size_t s = 0; s < frame.logs.size(); ++s)
                motion.rotation_log +=
                    weights_(group.vertices.front(), static_cast<Eigen::Index>(s)) * frame.logs[s];
    }
}

// Where the sheet takes them.
void SurfaceResponse::shift_bodies(Frame& frame) const
{
    for (const Group& group : groups_)
    {
        if (group.body < 0 || !input_.part.roles.bodies[at(group.body)].is_open())
            continue;
        const int first = group.vertices.front();
        const Vector3 start = input_.part.rest.points().row(first).transpose();
        RigidMotion& motion = frame.bodies.motions[at(group.body)];
        motion.translation.setZero();
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
    Eigen::MatrixXd fields(basis_.columns() - first_, 3);
    for (Eigen::Index k = 0; k < series_.count(); ++k)
        fields.middleRows(3 * k, 3) = fit.matrices[at(k)].transpose();
    Eigen::Index row = 3 * series_.count();
    for (const int handle : shifting_)
    {
        const Vector3& centre = groups_[at(handle)].centre;
        fields.row(row++) = (targets.handles[at(handle)].apply(centre) - centre).transpose();
    }
    fields.bottomRows(fields.rows() - row) =
        point_displacements(input_.part.rest, input_.part.constraints.points, targets.points);
    frame.handles = targets.handles;
    frame.bodies = known_body_motions(input_.part, targets);
    turn_bodies(frame);
    const FreeFields::Pose pose{input_.part, targets, frame.logs};
    const auto turns = free_.turn(pose, fields, frame.bodies, frame.free);
    if (!turns)
        return std::nullopt;
    frame.coefficients.setZero(basis_.columns(), 3);
    frame.coefficients.topRows(turns->rows()) = *turns;
    frame.coefficients.bottomRows(fields.rows()) = fields;
    shift_bodies(frame);
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
        free_.blend(frame.free, result.rotation_logs);
        input_.followers.place(rest, result.positions, result.rotation_logs);
    }
    result.features = frame.features;
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/rotation/far_turns.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/surface/operators/ties.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace sheetmorph::surface
{

namespace
{

// Angle between two given rotations of a component. Up to the first, `natural` is unchanged. From
// geometry: linear interpolation across an angle a narrows a strip to cos(a / 2), 0.87 at 60
// degrees and 0.5 at 120. From the second on, only the shape of the field counts.
constexpr double first_far = 60.0 * degree;
constexpr double wholly_far = 120.0 * degree;

double share_of(double angle)
{
    const double t = std::clamp((angle - first_far) / (wholly_far - first_far), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// Whether no two of these logs can differ by a large rotation.
bool is_small(double longest)
{
    return 4.0 * longest <= first_far;
}

// One vertex of every connected component is prescribed, because the shape is only unique up to a
// translation.
Unknowns all_but_one(const numerics::SparseMatrix& harmonic)
{
    const auto count = static_cast<int>(harmonic.rows());
    DisjointSets sets(count);
    for (int column = 0; column < count; ++column)
        for (numerics::SparseMatrix::InnerIterator entry(harmonic, column); entry; ++entry)
            if (entry.value() != 0.0)
                sets.join(column, static_cast<int>(entry.row()));
    Unknowns unknowns;
    for (int i = 0; i < count; ++i)
        unknowns.of_vertex.push_back(sets.root(i) == i ? Unknowns::known : unknowns.count++);
    return unknowns;
}

// The log of a source (FarTurns::Source).
template <typename Source>
Eigen::RowVector3d log_of(const Source& source, const KnownRotations& known)
{
    switch (source.kind)
    {
        case Source::Kind::handle:
            return known.handles.row(source.index);
        case Source::Kind::body:
            return known.bodies.row(source.index);
        case Source::Kind::region:
            return known.regions.row(source.index);
        case Source::Kind::point:
            return known.points.row(source.index);
        case Source::Kind::rest:
            break;
    }
    return Eigen::RowVector3d::Zero();
}

}  // namespace

bool FarTurns::Source::operator<(const Source& other) const
{
    return std::tie(component, kind, index) < std::tie(other.component, other.kind, other.index);
}

FarTurns::Factor::Factor(const SurfaceOperators& operators)
    : unknowns(all_but_one(*operators.harmonic)),
      cholesky(unknowns.merged(operators.harmonic), operators.harmonic_tree)
{
}

FarTurns::FarTurns(const RotationFieldInput& input, const RotationField& field)
    : input_(input), field_(field)
{
    find_sources();
}

void FarTurns::find_sources()
{
    const VertexRoles& roles = input_.roles;
    std::set<Source> found;
    const auto add = [&](int vertex, Source::Kind kind, int index)
    {
        if (roles.components.label[at(vertex)] != mesh::Components::unused)
            found.insert({roles.components.label[at(vertex)], kind, index});
    };
    for (int i = 0; i < input_.mesh.vertex_count(); ++i)
    {
        const int owner = roles.owner[at(i)];
        const Role role = roles.role[at(i)];
        if (role == Role::fixed)
            add(i, Source::Kind::rest, 0);
        else if (role == Role::handle)
            add(i, Source::Kind::handle, owner);
        else if (role == Role::propagated)
            add(i, Source::Kind::region, owner);
        else if (role == Role::body && is_rotation_known(roles, i))
            add(i, Source::Kind::body, owner);
    }
    const std::vector<PointConstraint>& points = input_.constraints.points;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (points[k].is_turned)
            add(input_.mesh.triangles()(points[k].triangle, 0), Source::Kind::point,
                static_cast<int>(k));
    sources_.assign(found.begin(), found.end());
}

// By component; empty if no rotation is large.
std::vector<double> FarTurns::shares(const GivenRotations& given) const
{
    std::vector<Eigen::RowVector3d> logs;
    double longest = 0.0;
    for (const Source& source : sources_)
    {
        logs.push_back(log_of(source, given.logs));
        longest = std::max(longest, logs.back().norm());
    }
    std::vector<double> shares;
    if (is_small(longest))
        return shares;
    std::vector<double> farthest(at(input_.roles.components.count), 0.0);
    for (std::size_t a = 0; a < sources_.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (sources_[a].component == sources_[b].component)
            {
                double& far = farthest[at(sources_[a].component)];
                far = std::max(far, 2.0 * (logs[a] - logs[b]).norm());
            }
    for (const double angle : farthest)
        shares.push_back(share_of(angle));
    const auto is_none = [](double share) { return share == 0.0; };
    if (std::all_of(shares.begin(), shares.end(), is_none))
        shares.clear();
    return shares;
}

bool FarTurns::are_there(const SurfaceTargets& targets, const BodyMotions& bodies) const
{
    double longest = bodies.logs.rows() == 0 ? 0.0 : bodies.logs.rowwise().norm().maxCoeff();
    for (const RigidMotion& handle : targets.handles)
        longest = std::max(longest, handle.rotation_log.norm());
    for (const PointTarget& point : targets.points)
        longest = std::max(longest, point.rotation_log.norm());
    for (const PropagatedTarget& region : targets.propagated)
        longest = std::max(longest, region.rotation_logs.rowwise().norm().maxCoeff());
    return !is_small(longest)
           && !shares(given_rotations({input_.mesh, input_.constraints, input_.roles}, targets,
                                      bodies))
                   .empty();
}

// Displacements d (n, 3) of the shape that the field determines.
Points FarTurns::laid(const Points& logs, const Points& tilts) const
{
    std::call_once(is_factorised_, [this] { factor_.emplace(input_.operators); });
    const numerics::SparseMatrix& harmonic = *input_.operators.harmonic;
    Points rest = input_.mesh.points();
    fill_tied(input_.roles.ties, rest);
    const auto count = static_cast<Eigen::Index>(factor_->unknowns.of_vertex.size());
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(factor_->unknowns.count, 3);
    const auto add = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index i = begin; i < end; ++i)
        {
            const int unknown = factor_->unknowns.of_vertex[at(i)];
            for (numerics::SparseMatrix::InnerIterator entry(harmonic, i);
                 entry && unknown != Unknowns::known; ++entry)
            {
                if (entry.row() == i)
                    continue;
                const Matrix3 turn =
                    tilted_rotation(0.5 * (logs.row(i) + logs.row(entry.row())).transpose(),
                                    0.5 * (tilts.row(i) + tilts.row(entry.row())).transpose());
                const Vector3 edge = (rest.row(i) - rest.row(entry.row())).transpose();
                pull.row(unknown) -= entry.value() * (turn * edge - edge).transpose();
            }
        }
    };
    parallel_ranges(count, microsecond_items, add);
    const Eigen::MatrixXd solved = factor_->cholesky.solve(pull);
    Points shape = Points::Zero(count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
        if (const int unknown = factor_->unknowns.of_vertex[at(i)]; unknown != Unknowns::known)
            shape.row(i) = solved.row(unknown);
    return shape;
}

double FarTurns::share_at(const std::vector<double>& shares, int vertex) const
{
    const int component = input_.roles.components.label[at(vertex)];
    return component == mesh::Components::unused ? 0.0 : shares[at(component)];
}

FarField FarTurns::bent(const GivenRotations& given, Points logs, const Points& tilts) const
{
    FarField field{std::move(logs), Points(0, 3)};
    const std::vector<double> share_of_component = shares(given);
    if (share_of_component.empty())
        return field;
    const Points even = field_.harmonic(given.logs);
    for (int i = 0; i < input_.mesh.vertex_count(); ++i)
        field.logs.row(i) += share_at(share_of_component, i) * (even.row(i) - field.logs.row(i));
    const SurfaceOperators& operators = input_.operators;
    const Points shape = laid(field.logs, tilts);
    Points& rows = field.rows = Points::Zero(operators.rest_rows.rows(), 3);
    for (int column = 0; column < operators.rows.outerSize(); ++column)
        for (numerics::SparseMatrix::InnerIterator entry(operators.rows, column); entry; ++entry)
        {
            const int vertex = operators.row_vertices[at(entry.row())];
            rows.row(entry.row()) += entry.value() * (shape.row(column) - shape.row(vertex));
        }
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
    {
        const int vertex = operators.row_vertices[at(row)];
        const Vector3 at_rest = operators.rest_rows.row(row).transpose();
        const Matrix3 turn =
            tilted_rotation(field.logs.row(vertex).transpose(), tilts.row(vertex).transpose());
        rows.row(row) = share_at(share_of_component, vertex)
                        * (rows.row(row) - (turn * at_rest - at_rest).transpose());
    }
    return field;
}

}  // namespace sheetmorph::surface

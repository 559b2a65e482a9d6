// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/surface_deformer.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/numerics/constrained_minimiser.h"
#include "sheetmorph/surface/constraint_checks.h"
#include "sheetmorph/surface/followers.h"
#include "sheetmorph/surface/placement.h"
#include "sheetmorph/surface/point_rows.h"
#include "sheetmorph/surface/rotation_field.h"
#include "sheetmorph/surface/surface_response.h"
#include "sheetmorph/surface/unknowns.h"

namespace sheetmorph
{

namespace
{

// Clean meshes settle after one or two; a few needles in the mesh need more.
constexpr int most_refinements = 8;

std::size_t at(Eigen::Index index)
{
    return static_cast<std::size_t>(index);
}

// Free vertices have an unknown each, bodies whose translation is open share one.
Unknowns position_unknowns(const VertexRoles& roles)
{
    Unknowns unknowns;
    std::vector<int> of_body(roles.bodies.size(), Unknowns::known);
    for (std::size_t i = 0; i < roles.role.size(); ++i)
    {
        int unknown = Unknowns::known;
        if (roles.role[i] == Role::free)
            unknown = unknowns.count++;
        else if (roles.role[i] == Role::body && !roles.bodies[at(roles.owner[i])].is_known())
        {
            int& shared = of_body[at(roles.owner[i])];
            if (shared == Unknowns::known)
                shared = unknowns.count++;
            unknown = shared;
        }
        unknowns.of_vertex.push_back(unknown);
    }
    return unknowns;
}

std::vector<int> all_of(std::size_t count)
{
    std::vector<int> ids;
    for (std::size_t k = 0; k < count; ++k)
        ids.push_back(static_cast<int>(k));
    return ids;
}

// Points that alone hold a component: the energy does not see where it is.
std::vector<int> supporting_points(const TriangleMesh& rest, const VertexRoles& roles,
                                   const SurfaceConstraints& constraints)
{
    std::vector<int> supporting;
    for (std::size_t k = 0; k < constraints.points.size(); ++k)
    {
        const int corner = rest.triangles()(constraints.points[k].triangle, 0);
        const int component = roles.components.label[at(corner)];
        for (const int held : roles.held_by_points)
            if (held == component)
                supporting.push_back(static_cast<int>(k));
    }
    return supporting;
}

ConstrainedMinimiser position_minimiser(const RotationFieldInput& input, const Unknowns& unknowns)
{
    QuadraticProblem problem;
    problem.rows = input.operators.rows;
    problem.weights = input.operators.weights;
    problem.basis = unknowns.basis();
    const std::vector<PointConstraint>& points = input.constraints.points;
    problem.constraints = point_rows(input.mesh, points, all_of(points.size()));
    problem.supporting = supporting_points(input.mesh, input.roles, input.constraints);
    return ConstrainedMinimiser(std::move(problem));
}

std::unique_ptr<RotationField> rotation_field(const RotationFieldInput& input)
{
    return input.constraints.energy == Energy::paper ? biharmonic_rotation_field(input)
                                                     : blended_rotation_field(input);
}

// (R - I) D p_hat: how the rest rows turn.
Eigen::MatrixXd turned_rows(const SurfaceOperators& operators, const Points& logs,
                            const Points& tilts)
{
    Eigen::MatrixXd change(operators.rest_rows.rows(), 3);
    for (Eigen::Index row = 0; row < change.rows(); ++row)
    {
        const Vector3 rest = operators.rest_rows.row(row).transpose();
        const int vertex = operators.row_vertices[at(row)];
        const Matrix3 rotation = tilted_rotation(logs.row(vertex), tilts.row(vertex));
        change.row(row) = (rotation * rest - rest).transpose();
    }
    return change;
}

}  // namespace

struct SurfaceDeformer::Precomputed
{
    Precomputed(const TriangleMesh& rest_mesh, const SurfaceConstraints& given,
                const Progress& progress);

    void require_met_points(const Eigen::MatrixXd& displacements, const Eigen::MatrixXd& wanted,
                            Exactness exactness) const;
    PlacementInput placement() const { return {rest, constraints, roles}; }

    TriangleMesh rest;
    SurfaceConstraints constraints;
    VertexRoles roles;
    SurfaceOperators operators;
    Unknowns unknowns;
    std::unique_ptr<RotationField> field;
    ConstrainedMinimiser minimiser;
    Followers followers;
};

namespace
{

VertexRoles reported_roles(const TriangleMesh& rest, const SurfaceConstraints& constraints,
                           const Progress& progress)
{
    progress.report(0.0, "checking constraints");
    return assign_roles(rest, constraints);
}

SurfaceOperators reported_operators(const TriangleMesh& rest, Energy energy,
                                    const Progress& progress)
{
    progress.report(0.1, "operators");
    return surface_operators(rest, energy);
}

std::unique_ptr<RotationField> reported_field(const RotationFieldInput& input,
                                              const Progress& progress)
{
    progress.report(0.2, "rotation field");
    return rotation_field(input);
}

ConstrainedMinimiser reported_minimiser(const RotationFieldInput& input, const Unknowns& unknowns,
                                        const Progress& progress)
{
    progress.report(0.4, "factorisation");
    return position_minimiser(input, unknowns);
}

}  // namespace

SurfaceDeformer::Precomputed::Precomputed(const TriangleMesh& rest_mesh,
                                          const SurfaceConstraints& given, const Progress& progress)
    : rest(rest_mesh),
      constraints(given),
      roles(reported_roles(rest, constraints, progress)),
      operators(reported_operators(rest, constraints.energy, progress)),
      unknowns(position_unknowns(roles)),
      field(reported_field({rest, constraints, roles, operators}, progress)),
      minimiser(reported_minimiser({rest, constraints, roles, operators}, unknowns, progress)),
      followers(rest, roles)
{
    progress.report(1.0, "ready");
}

void SurfaceDeformer::Precomputed::require_met_points(const Eigen::MatrixXd& displacements,
                                                      const Eigen::MatrixXd& wanted,
                                                      Exactness level) const
{
    const Eigen::VectorXd error = minimiser.constraint_error(displacements, wanted);
    const double reach = rest.size() + (wanted.size() ? wanted.cwiseAbs().maxCoeff() : 0.0);
    const double allowed =
        level == Exactness::exact ? exactness(rest.points(), reach) : 1e-6 * reach;
    std::string missed;
    for (Eigen::Index k = 0; k < error.size(); ++k)
        if (error(k) > allowed)
            missed += (missed.empty() ? "'" : ", '") + constraints.points[at(k)].name + "'";
    if (!missed.empty())
        throw InvalidInput("the targets of points " + missed
                           + " contradict each other or the fixed, handle or feature vertices they "
                             "lie on; move a target or remove a point");
}

SurfaceDeformer::SurfaceDeformer(const TriangleMesh& rest, const SurfaceConstraints& constraints,
                                 const Progress& progress)
    : data_(std::make_unique<const Precomputed>(rest, constraints, progress))
{
}

SurfaceDeformer::~SurfaceDeformer() = default;
SurfaceDeformer::SurfaceDeformer(SurfaceDeformer&&) noexcept = default;
SurfaceDeformer& SurfaceDeformer::operator=(SurfaceDeformer&&) noexcept = default;

Deformation SurfaceDeformer::deform(const SurfaceTargets& targets, Exactness exactness) const
{
    check_targets(data_->constraints, targets);
    const PlacementInput part = data_->placement();
    BodyMotions bodies = known_body_motions(part, targets);
    Deformation result;
    const GivenRotations given = given_rotations(part, targets, bodies);
    result.rotation_logs = data_->field->logs(given.logs);
    const Points tilts = given.is_tilted ? data_->field->logs(given.tilts)
                                         : Points(Points::Zero(data_->rest.vertex_count(), 3));
    turn_open_bodies(part, result.rotation_logs, tilts, bodies);
    ConstrainedMinimiser::Targets problem;
    problem.rows = turned_rows(data_->operators, result.rotation_logs, tilts);
    problem.offset = known_displacements(part, targets, bodies);
    problem.constraints =
        point_displacements(data_->rest, data_->constraints.points, targets.points);
    const Eigen::MatrixXd displacements =
        data_->minimiser.solve(problem, exactness == Exactness::exact ? most_refinements : 0);
    data_->require_met_points(displacements, problem.constraints, exactness);
    complete_bodies(part, displacements, bodies);
    result.positions = placed_positions(part, targets, bodies, displacements);
    data_->followers.place(data_->rest, result.positions, result.rotation_logs);
    result.features = feature_motions(part, bodies);
    if (!result.positions.allFinite())
        throw SolverError("the deformed shape is not finite; the mesh may be too distorted");
    return result;
}

std::unique_ptr<SurfaceResponse> SurfaceDeformer::response(const ResponseOptions& options,
                                                           const Progress& progress) const
{
    const ResponseInput input{data_->placement(), data_->operators, *data_->field, data_->minimiser,
                              data_->followers};
    return std::make_unique<SurfaceResponse>(input, options, progress);
}

const TriangleMesh& SurfaceDeformer::rest() const
{
    return data_->rest;
}

const SurfaceConstraints& SurfaceDeformer::constraints() const
{
    return data_->constraints;
}

double SurfaceDeformer::factor_entries() const
{
    return data_->minimiser.factor_entries();
}

}  // namespace sheetmorph

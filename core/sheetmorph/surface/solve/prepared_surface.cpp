// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/prepared_surface.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/bodies/clamping.h"
#include "sheetmorph/surface/operators/point_rows.h"
#include "sheetmorph/surface/operators/shared_unknowns.h"

namespace sheetmorph::surface
{

namespace
{

// One unknown per free vertex, and one per body whose translation depends on the sheet.
Unknowns position_unknowns(const VertexRoles& roles)
{
    SharedUnknowns unknowns(roles);
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        unknowns.add(
            roles.role[i] == Role::free
            || (roles.role[i] == Role::body && roles.bodies[at(roles.owner[i])].is_open()));
    return unknowns.found();
}

std::vector<int> all_of(std::size_t count)
{
    std::vector<int> ids;
    for (std::size_t k = 0; k < count; ++k)
        ids.push_back(static_cast<int>(k));
    return ids;
}

// Points that alone support a component; the energy does not determine its position.
std::vector<int> supporting_points(const mesh::TriangleMesh& rest, const VertexRoles& roles,
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

numerics::QuadraticProblem position_problem(const RotationFieldInput& input,
                                            const Unknowns& unknowns)
{
    numerics::QuadraticProblem problem;
    problem.rows = input.operators.rows;
    problem.weights = input.operators.weights;
    problem.basis = unknowns.basis();
    problem.stiffness = input.operators.stiffness;
    problem.tree = input.operators.tree;
    const std::vector<PointConstraint>& points = input.constraints.points;
    problem.constraints = point_rows(input.mesh, points, all_of(points.size()));
    problem.supporting = supporting_points(input.mesh, input.roles, input.constraints);
    return problem;
}

std::unique_ptr<RotationField> rotation_field(const RotationFieldInput& input,
                                              const RotationField* earlier)
{
    return input.constraints.energy == Energy::paper ? biharmonic_rotation_field(input, earlier)
                                                     : blended_rotation_field(input, earlier);
}

VertexRoles reported_roles(const mesh::TriangleMesh& rest, const SurfaceConstraints& constraints,
                           const Progress& progress)
{
    progress.report(0.0, "checking constraints");
    return assign_roles(rest, constraints);
}

// Clamps neighbours after the operators are assembled, because they contain the edges of the sheet.
std::shared_ptr<const SurfaceOperators> reported_operators(const mesh::TriangleMesh& rest,
                                                           const SurfaceConstraints& constraints,
                                                           VertexRoles& roles,
                                                           const Progress& progress)
{
    progress.report(0.1, "operators");
    auto operators =
        std::make_shared<const SurfaceOperators>(surface_operators(rest, constraints, roles));
    if (constraints.energy == Energy::natural)
        clamp_neighbours(rest, constraints, *operators->harmonic, roles);
    return operators;
}

// Returns the earlier state of the part if its operators are still valid. Operators of `natural`
// depend on the prescribed regions. Operators with ties depend on the roles of their vertices.
const PreparedSurface* with_same_operators(const PreparedSurface* earlier,
                                           const mesh::TriangleMesh& rest,
                                           const SurfaceConstraints& constraints)
{
    const bool is_same = earlier != nullptr && constraints.energy != Energy::natural
                         && earlier->constraints.energy == constraints.energy
                         && earlier->constraints.laplacian == constraints.laplacian
                         && earlier->constraints.ties.empty() && constraints.ties.empty()
                         && earlier->rest == rest;
    return is_same ? earlier : nullptr;
}

std::unique_ptr<RotationField> reported_field(const RotationFieldInput& input,
                                              const PreparedSurface* earlier,
                                              const Progress& progress)
{
    progress.report(0.2, "rotation field");
    return rotation_field(input, earlier != nullptr ? earlier->field.get() : nullptr);
}

numerics::ConstrainedMinimiser reported_minimiser(const RotationFieldInput& input,
                                                  const Unknowns& unknowns,
                                                  const PreparedSurface* earlier,
                                                  const Progress& progress)
{
    progress.report(0.4, "factorisation");
    return numerics::ConstrainedMinimiser(position_problem(input, unknowns),
                                          earlier != nullptr ? &earlier->minimiser : nullptr);
}

std::unique_ptr<FeatureResponses> reported_responses(
    const RotationFieldInput& input, const numerics::ConstrainedMinimiser& minimiser,
    const Progress& progress)
{
    std::vector<Turner> turners = turners_of(input.mesh, input.constraints, input.roles);
    if (turners.empty())
        return nullptr;
    progress.report(0.7, "responses of features");
    return std::make_unique<FeatureResponses>(input, minimiser, std::move(turners));
}

}  // namespace

PreparedSurface::PreparedSurface(const mesh::TriangleMesh& rest_mesh,
                                 const SurfaceConstraints& given, const Progress& progress,
                                 const PreparedSurface* earlier)
    : PreparedSurface(rest_mesh, given, progress,
                      Reuse{with_same_operators(earlier, rest_mesh, given)})
{
}

PreparedSurface::PreparedSurface(const mesh::TriangleMesh& rest_mesh,
                                 const SurfaceConstraints& given, const Progress& progress,
                                 Reuse reuse)
    : rest(rest_mesh),
      constraints(given),
      roles(reported_roles(rest, constraints, progress)),
      shapes(resizable_shapes(rest, constraints)),
      shared_operators(reuse.earlier != nullptr
                           ? reuse.earlier->shared_operators
                           : reported_operators(rest, constraints, roles, progress)),
      operators(*shared_operators),
      unknowns(position_unknowns(roles)),
      field(reported_field({rest, constraints, roles, operators}, reuse.earlier, progress)),
      far_turns(constraints.energy == Energy::natural ? std::make_unique<const FarTurns>(
                    RotationFieldInput{rest, constraints, roles, operators}, *field)
                                                      : nullptr),
      minimiser(reported_minimiser({rest, constraints, roles, operators}, unknowns, reuse.earlier,
                                   progress)),
      responses(reported_responses({rest, constraints, roles, operators}, minimiser, progress)),
      steel(constraints.has_previews() ? std::make_unique<SteelAnswer>(rest, constraints)
                                       : nullptr),
      growth({rest, constraints, roles, operators}, shapes),
      followers(rest, roles)
{
    progress.report(1.0, "ready");
}

}  // namespace sheetmorph::surface

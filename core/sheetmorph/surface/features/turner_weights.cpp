// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/features/turner_weights.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/operators/shared_unknowns.h"

#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

constexpr int none = -1;

// By vertex: the body with which it rotates fully, or none.
std::vector<int> owners(int vertex_count, const std::vector<Turner>& turners)
{
    std::vector<int> owner(at(vertex_count), none);
    for (std::size_t k = 0; k < turners.size(); ++k)
        if (turners[k].turns)
            for (const int vertex : turners[k].vertices)
                owner[at(vertex)] = static_cast<int>(k);
    return owner;
}

bool is_told_by_point(const RotationFieldInput& input, int vertex)
{
    const std::vector<PointConstraint>& points = input.constraints.points;
    return std::any_of(
        points.begin(), points.end(),
        [&](const PointConstraint& point)
        {
            return point.is_turned
                   && (input.mesh.triangles().row(point.triangle).array() == vertex).any();
        });
}

// Free vertices between rotating bodies and prescribed rotations, in components that contain a
// rotating body.
Unknowns open_vertices(const RotationFieldInput& input, const std::vector<int>& owner)
{
    const std::vector<int>& label = input.roles.components.label;
    std::vector<char> has_turner(at(input.roles.components.count), 0);
    for (std::size_t i = 0; i < owner.size(); ++i)
        if (owner[i] != none && label[i] >= 0)
            has_turner[at(label[i])] = 1;
    SharedUnknowns unknowns(input.roles);
    for (int i = 0; i < input.mesh.vertex_count(); ++i)
        unknowns.add(input.roles.role[at(i)] == Role::free && owner[at(i)] == none
                     && label[at(i)] >= 0 && has_turner[at(label[at(i)])]
                     && !is_told_by_point(input, i));
    return unknowns.found();
}

// A smaller weight counts as zero, so that distant features do not interact. Chosen: a rotation by
// one radian would reach such a vertex as 3e-6 radians (smoothstep, 3 w^2), which does not show.
constexpr double faded = 1e-3;

}  // namespace

SmoothWeights turner_weights(const RotationFieldInput& input, const std::vector<Turner>& turners)
{
    if (turners.empty())
        return SmoothWeights(input.mesh.vertex_count());
    const std::vector<int> owner = owners(input.mesh.vertex_count(), turners);
    std::vector<VertexIds> owned(turners.size());
    for (std::size_t i = 0; i < owner.size(); ++i)
        if (owner[i] != none)
            owned[at(owner[i])].push_back(static_cast<int>(i));
    const SurfaceOperators& operators = input.operators;
    const Unknowns unknowns = open_vertices(input, owner);
    const numerics::SparseCholesky factor(unknowns.merged(operators.harmonic),
                                          operators.harmonic_tree);
    SmoothWeights weights({*operators.harmonic, unknowns, factor}, owned, {faded, 0.0, true});
    weights.fill_tied(input.roles.ties);
    return weights;
}

}  // namespace sheetmorph::surface

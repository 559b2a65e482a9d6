// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/clamping.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"

#include <map>
#include <utility>

namespace sheetmorph::surface
{

namespace
{

// Relative tolerance of equal distances to carriers; symmetric meshes have such pairs. From files
// with seven digits, whose rounding must not choose between them.
constexpr double as_near = 1.0 + 1e-6;

// The nearest carriers of each region, with equal weights per region.
Clamp clamp_of(const mesh::TriangleMesh& mesh, const VertexRoles& roles, int vertex,
               const VertexIds& candidates)
{
    const auto distance = [&](int carrier)
    { return (mesh.points().row(carrier) - mesh.points().row(vertex)).norm(); };
    const auto region_of = [&](int carrier)
    { return std::pair(roles.role[at(carrier)], roles.owner[at(carrier)]); };
    std::map<std::pair<Role, int>, double> nearest;
    for (const int carrier : candidates)
    {
        const auto [found, is_new] = nearest.emplace(region_of(carrier), distance(carrier));
        if (!is_new)
            found->second = std::min(found->second, distance(carrier));
    }
    std::map<std::pair<Role, int>, VertexIds> carriers;
    for (const int carrier : candidates)
        if (distance(carrier) <= as_near * nearest[region_of(carrier)])
            carriers[region_of(carrier)].push_back(carrier);
    Clamp clamp;
    clamp.vertex = vertex;
    for (const auto& [region, of_region] : carriers)
        for (const int carrier : of_region)
            clamp.carriers.push_back(
                {carrier, 1.0 / static_cast<double>(carriers.size() * of_region.size())});
    return clamp;
}

}  // namespace

std::vector<char> holding_vertices(const SurfaceConstraints& constraints, const VertexRoles& roles)
{
    std::vector<char> holds(roles.role.size(), 0);
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        holds[i] = roles.role[i] == Role::fixed || roles.role[i] == Role::handle
                   || roles.role[i] == Role::propagated;
    for (const KnownRegion& region : constraints.propagated)
        for (const int vertex : region.vertices)
            holds[at(vertex)] = 1;
    return holds;
}

void clamp_neighbours(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                      const numerics::SparseMatrix& neighbours, VertexRoles& roles)
{
    const std::vector<char> clamps = holding_vertices(constraints, roles);
    for (int i = 0; i < mesh.vertex_count(); ++i)
    {
        if (roles.role[at(i)] != Role::free)
            continue;
        VertexIds candidates;
        for (numerics::SparseMatrix::InnerIterator entry(neighbours, i); entry; ++entry)
            if (entry.row() != i && clamps[at(static_cast<int>(entry.row()))])
                candidates.push_back(static_cast<int>(entry.row()));
        if (!candidates.empty())
            roles.clamps.push_back(clamp_of(mesh, roles, i, candidates));
    }
    for (std::size_t k = 0; k < roles.clamps.size(); ++k)
    {
        roles.role[at(roles.clamps[k].vertex)] = Role::clamped;
        roles.owner[at(roles.clamps[k].vertex)] = static_cast<int>(k);
    }
}

void turn_clamped(const VertexRoles& roles, KnownRotations& rotations)
{
    for (const Clamp& clamp : roles.clamps)
    {
        Vector3 mean = Vector3::Zero();
        for (const Clamp::Carrier& carrier : clamp.carriers)
            mean += carrier.weight * rotations.vertices.row(carrier.vertex).transpose();
        rotations.vertices.row(clamp.vertex) = mean.transpose();
    }
}

void place_clamped(const PlacementInput& part, const GivenRotations& given,
                   Eigen::MatrixXd& displacements)
{
    for (const Clamp& clamp : part.roles.clamps)
    {
        Vector3 mean = Vector3::Zero();
        for (const Clamp::Carrier& carrier : clamp.carriers)
        {
            const Vector3 arm = part.rest.points().row(clamp.vertex).transpose()
                                - part.rest.points().row(carrier.vertex).transpose();
            const Matrix3 rotation = tilted_rotation(given.logs.vertices.row(carrier.vertex),
                                                     given.tilts.vertices.row(carrier.vertex));
            const Vector3 shift = displacements.row(carrier.vertex).transpose();
            mean += carrier.weight * (shift + (rotation * arm - arm));
        }
        displacements.row(clamp.vertex) = mean.transpose();
    }
}

}  // namespace sheetmorph::surface

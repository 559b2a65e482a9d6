// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/turners.h"

#include "sheetmorph/base/index.h"

namespace sheetmorph::surface
{

namespace
{

// A point rotates the corners of its triangle that no other constraint determines.
Turner turner_of_point(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                       const VertexRoles& roles, int point)
{
    Turner turner;
    turner.point = point;
    for (int corner = 0; corner < 3; ++corner)
    {
        const int vertex = mesh.triangles()(constraints.points[at(point)].triangle, corner);
        if (roles.role[at(vertex)] == Role::free)
            turner.vertices.push_back(vertex);
    }
    return turner;
}

}  // namespace

std::vector<Turner> turners_of(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints, const VertexRoles& roles)
{
    std::vector<Turner> turners;
    for (const int index : leaders_first(roles.bodies))
    {
        const Body& body = roles.bodies[at(index)];
        const bool turns = body.motion == Body::Motion::free;
        if (turns || body.is_bound)
            turners.push_back({index, -1, turns, body.is_bound, body.vertices, false});
    }
    std::vector<char> is_taken(roles.role.size(), 0);
    for (std::size_t k = 0; k < constraints.points.size(); ++k)
    {
        if (!constraints.points[k].is_rotation_free)
            continue;
        Turner turner = turner_of_point(mesh, constraints, roles, static_cast<int>(k));
        bool is_new = !turner.vertices.empty();
        for (const int vertex : turner.vertices)
            is_new &= !is_taken[at(vertex)];
        for (const int vertex : turner.vertices)
            is_taken[at(vertex)] = 1;
        if (is_new)
            turners.push_back(std::move(turner));
    }
    return turners;
}

BodyMotions unmoved_turners(const std::vector<Turner>& turners, BodyMotions bodies)
{
    for (const Turner& turner : turners)
        if (turner.body >= 0 && turner.is_turned())
            bodies.motions[at(turner.body)].rotation_log.setZero();
    return bodies;
}

}  // namespace sheetmorph::surface

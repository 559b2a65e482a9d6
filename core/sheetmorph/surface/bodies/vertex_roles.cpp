// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/vertex_roles.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/constraints/constraint_checks.h"

#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

void set_role(VertexRoles& roles, int vertex, Role role, int owner)
{
    roles.role[at(vertex)] = role;
    roles.owner[at(vertex)] = owner;
}

void mark_propagated(VertexRoles& roles, const SurfaceConstraints& constraints)
{
    for (std::size_t region = 0; region < constraints.propagated.size(); ++region)
        for (const int vertex : constraints.propagated[region].vertices)
            set_role(roles, vertex, Role::propagated, static_cast<int>(region));
}

void mark_fixed(VertexRoles& roles, const SurfaceConstraints& constraints)
{
    for (const KnownRegion& region : constraints.fixed)
        for (const int vertex : region.vertices)
            set_role(roles, vertex, Role::fixed, -1);
}

void mark_handle(VertexRoles& roles, const SurfaceConstraints& constraints, int handle)
{
    const KnownRegion& region = constraints.handles[at(handle)];
    VertexIds shared;
    int other = -1;
    bool moves_something = false;
    for (const int vertex : region.vertices)
    {
        const Role role = roles.role[at(vertex)];
        if (role == Role::handle && roles.owner[at(vertex)] != handle)
        {
            shared.push_back(vertex);
            other = roles.owner[at(vertex)];
        }
        else if (role != Role::fixed)
        {
            set_role(roles, vertex, Role::handle, handle);
            moves_something = true;
        }
    }
    if (!shared.empty())
        throw InvalidInput(constraints.handles[at(other)].label() + " and " + region.label()
                               + " both move " + Text::counted(shared),
                           "remove these from one of them", FaultCode::overlap);
    if (!moves_something)
        throw InvalidInput("every vertex of " + region.label() + " is fixed, so it cannot move",
                           "remove them from the fixed region");
}

// Whether points of a body's own triangles determine its rotation: one with a rotation, or several
// that pin it.
bool is_turned_by_points(const Body& body, const mesh::TriangleMesh& mesh,
                         const SurfaceConstraints& constraints)
{
    const auto is_own = [&](int vertex)
    { return std::binary_search(body.vertices.begin(), body.vertices.end(), vertex); };
    int pins = 0;
    for (const PointConstraint& point : constraints.points)
    {
        int corners = 0;
        for (int corner = 0; corner < 3; ++corner)
            corners += is_own(mesh.triangles()(point.triangle, corner)) ? 1 : 0;
        if (point.is_turned && corners > 0)
            return true;
        pins += corners == 3 ? 1 : 0;
    }
    return pins > 1;
}

Drivers drivers_of(const Body& body, const VertexRoles& roles)
{
    Drivers drivers;
    for (const int vertex : body.vertices)
    {
        drivers.fixed |= roles.role[at(vertex)] == Role::fixed;
        drivers.propagated |= roles.role[at(vertex)] == Role::propagated;
        if (roles.role[at(vertex)] == Role::handle)
            drivers.handles.insert(roles.owner[at(vertex)]);
    }
    return drivers;
}

void mark_bodies(VertexRoles& roles, const mesh::TriangleMesh& mesh,
                 const SurfaceConstraints& constraints)
{
    for (std::size_t k = 0; k < roles.bodies.size(); ++k)
    {
        Body& body = roles.bodies[k];
        Drivers drivers = drivers_of(body, roles);
        drivers.turned = is_turned_by_points(body, mesh, constraints);
        decide_motion(body, drivers, constraints);
        for (const int vertex : body.vertices)
            if (roles.role[at(vertex)] != Role::fixed && roles.role[at(vertex)] != Role::handle)
                set_role(roles, vertex, Role::body, static_cast<int>(k));
        // A size moves vertices that fixed regions and handles would otherwise prescribe.
        for (const int feature : body.features)
            if (constraints.features[at(feature)].is_resizable)
                for (const int vertex : constraints.features[at(feature)].vertices)
                    set_role(roles, vertex, Role::body, static_cast<int>(k));
    }
    decide_links(mesh, constraints, roles.bodies);
}

// \returns groups of vertices connected by ties
std::vector<VertexIds> mark_ties(VertexRoles& roles, const SurfaceConstraints& constraints)
{
    std::vector<VertexIds> found;
    for (const Tie& tie : constraints.ties)
    {
        if (roles.role[at(tie.vertex)] != Role::free)
            continue;
        set_role(roles, tie.vertex, Role::tied, -1);
        roles.ties.push_back(tie);
        found.push_back({tie.vertex});
        for (std::size_t k = 0; k < 3; ++k)
            if (tie.place.weights(static_cast<Eigen::Index>(k)) > 0.0)
                found.back().push_back(tie.place.corners[k]);
    }
    return found;
}

void require_bodies_on_the_sheet(const VertexRoles& roles, const SurfaceConstraints& constraints)
{
    for (const Body& body : roles.bodies)
    {
        const auto on_sheet = [&](int vertex)
        { return roles.components.label[at(vertex)] != mesh::Components::unused; };
        if (!body.is_known() && std::none_of(body.vertices.begin(), body.vertices.end(), on_sheet))
            throw InvalidInput(names_of(body, constraints) + " has only vertices of no triangle: "
                                   + Text::listed("", body.vertices),
                               "nothing can move it, remove it");
    }
}

// Whether a body supports its component. A handle with a free rotation supports it by its pivot.
bool is_held(const Body& body)
{
    return body.is_known() || body.handle >= 0;
}

std::vector<char> held_components(const VertexRoles& roles)
{
    std::vector<char> held(at(roles.components.count), 0);
    for (std::size_t i = 0; i < roles.role.size(); ++i)
    {
        const Role role = roles.role[i];
        const bool known = role == Role::fixed || role == Role::handle || role == Role::propagated
                           || (role == Role::body && is_held(roles.bodies[at(roles.owner[i])]));
        if (known && roles.components.label[i] != mesh::Components::unused)
            held[at(roles.components.label[i])] = 1;
    }
    return held;
}

// Marks components that only points support.
// \returns unsupported components
std::vector<int> find_held_components(VertexRoles& roles, const mesh::TriangleMesh& mesh,
                                      const SurfaceConstraints& constraints)
{
    const std::vector<char> held = held_components(roles);
    std::vector<char> pointed(held.size(), 0);
    for (const PointConstraint& point : constraints.points)
    {
        const int component = roles.components.label[at(mesh.triangles()(point.triangle, 0))];
        if (component != mesh::Components::unused)
            pointed[at(component)] = 1;
    }
    std::vector<int> unheld;
    for (int component = 0; component < roles.components.count; ++component)
        if (!held[at(component)])
            (pointed[at(component)] ? roles.held_by_points : unheld).push_back(component);
    return unheld;
}

// (n) whether a vertex belongs to a triangle. The sheet does not move other vertices; they stay at
// rest.
std::vector<char> corners_of(const mesh::TriangleMesh& mesh)
{
    std::vector<char> is_corner(at(mesh.vertex_count()), 0);
    for (const int corner : mesh.triangles().reshaped())
        is_corner[at(corner)] = 1;
    return is_corner;
}

VertexRoles roles_of(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints)
{
    check_constraints(mesh, constraints);
    VertexRoles roles;
    roles.role.assign(at(mesh.vertex_count()), Role::free);
    roles.owner.assign(at(mesh.vertex_count()), -1);
    roles.bodies = merge_bodies(mesh, constraints);
    mark_propagated(roles, constraints);
    mark_fixed(roles, constraints);
    for (std::size_t handle = 0; handle < constraints.handles.size(); ++handle)
        if (!constraints.handles[handle].is_rotation_free)
            mark_handle(roles, constraints, static_cast<int>(handle));
    mark_bodies(roles, mesh, constraints);
    std::vector<VertexIds> joined = mark_ties(roles, constraints);
    for (const Body& body : roles.bodies)
        joined.push_back(body.vertices);
    roles.components = mesh::connected_components(mesh, joined);
    require_bodies_on_the_sheet(roles, constraints);
    return roles;
}

}  // namespace

std::vector<VertexIds> unheld_components(const mesh::TriangleMesh& mesh,
                                         const SurfaceConstraints& constraints)
{
    VertexRoles roles = roles_of(mesh, constraints);
    const std::vector<int> unheld = find_held_components(roles, mesh, constraints);
    std::vector<int> place(at(roles.components.count), -1);
    for (std::size_t k = 0; k < unheld.size(); ++k)
        place[at(unheld[k])] = static_cast<int>(k);
    std::vector<VertexIds> found(unheld.size());
    for (int i = 0; i < mesh.vertex_count() && !found.empty(); ++i)
        if (const int label = roles.components.label[at(i)];
            label != mesh::Components::unused && place[at(label)] >= 0)
            found[at(place[at(label)])].push_back(i);
    return found;
}

VertexRoles assign_roles(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints)
{
    VertexRoles roles = roles_of(mesh, constraints);
    const std::vector<int> unheld = find_held_components(roles, mesh, constraints);
    if (!unheld.empty())
        throw InvalidInput(
            "nothing constrains the component of "
                + Text::listed("vertices ", roles.components.vertices(unheld.front())),
            "mark a fixed region or a handle on it, or remove it", FaultCode::unheld);
    const std::vector<char> is_corner = corners_of(mesh);
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        if (roles.role[i] == Role::free && roles.components.label[i] == mesh::Components::unused)
            roles.role[i] = is_corner[i] ? Role::follower : Role::fixed;
    return roles;
}

}  // namespace sheetmorph::surface

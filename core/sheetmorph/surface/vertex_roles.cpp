// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/vertex_roles.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/surface/constraint_checks.h"

#include <algorithm>
#include <set>

namespace sheetmorph
{

namespace
{

std::size_t at(int index)
{
    return static_cast<std::size_t>(index);
}

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
                               + " both move vertices ",
                           shared, "; take these out of one of them");
    if (!moves_something)
        throw InvalidInput("every vertex of " + region.label()
                           + " is fixed, so it cannot move; take them out of the fixed region");
}

std::vector<Body> merge_features(const TriangleMesh& mesh, const SurfaceConstraints& constraints)
{
    const auto count = static_cast<int>(constraints.features.size());
    DisjointSets sets(count);
    std::vector<int> first_owner(at(mesh.vertex_count()), -1);
    for (int feature = 0; feature < count; ++feature)
        for (const int vertex : constraints.features[at(feature)].vertices)
        {
            int& owner = first_owner[at(vertex)];
            if (owner < 0)
                owner = feature;
            sets.join(owner, feature);
        }
    std::vector<Body> bodies;
    std::vector<int> body_of(at(count), -1);
    for (int feature = 0; feature < count; ++feature)
    {
        int& body = body_of[at(sets.root(feature))];
        if (body < 0)
        {
            body = static_cast<int>(bodies.size());
            bodies.emplace_back();
        }
        bodies[at(body)].features.push_back(feature);
        VertexIds& vertices = bodies[at(body)].vertices;
        const VertexIds& more = constraints.features[at(feature)].vertices;
        vertices.insert(vertices.end(), more.begin(), more.end());
    }
    for (Body& body : bodies)
    {
        std::sort(body.vertices.begin(), body.vertices.end());
        body.vertices.erase(std::unique(body.vertices.begin(), body.vertices.end()),
                            body.vertices.end());
        for (const int vertex : body.vertices)
            body.centre += mesh.points().row(vertex).transpose();
        body.centre /= static_cast<double>(body.vertices.size());
    }
    return bodies;
}

std::string names_of(const Body& body, const SurfaceConstraints& constraints)
{
    std::string text;
    for (const int feature : body.features)
        text += (text.empty() ? "" : ", ") + constraints.features[at(feature)].label();
    if (body.features.size() > 1)
        text += " (one body, since they share vertices)";
    return text;
}

//! Everything that wants to move one body.
struct Drivers
{
    bool fixed = false;
    bool propagated = false;
    std::set<int> handles;
    std::vector<int> prescribed;
};

Drivers drivers_of(const Body& body, const VertexRoles& roles,
                   const SurfaceConstraints& constraints)
{
    Drivers drivers;
    for (const int vertex : body.vertices)
    {
        drivers.fixed |= roles.role[at(vertex)] == Role::fixed;
        drivers.propagated |= roles.role[at(vertex)] == Role::propagated;
        if (roles.role[at(vertex)] == Role::handle)
            drivers.handles.insert(roles.owner[at(vertex)]);
    }
    for (const int feature : body.features)
        if (constraints.features[at(feature)].is_prescribed)
            drivers.prescribed.push_back(feature);
    return drivers;
}

void refuse_contradictions(const Body& body, const Drivers& drivers,
                           const SurfaceConstraints& constraints)
{
    std::vector<std::string> movers;
    if (drivers.fixed)
        movers.emplace_back("a fixed region");
    for (const int handle : drivers.handles)
        movers.push_back(constraints.handles[at(handle)].label());
    for (const int feature : drivers.prescribed)
        movers.push_back("the rotation prescribed for '" + constraints.features[at(feature)].name
                         + "'");
    if (movers.size() < 2)
        return;
    throw InvalidInput(names_of(body, constraints) + " would be torn between " + movers[0] + " and "
                       + movers[1]
                       + ", which can move differently; let the rigid shape touch only one");
}

void decide_motion(Body& body, const Drivers& drivers)
{
    if (drivers.fixed)
        body.motion = Body::Motion::fixed;
    else if (!drivers.handles.empty())
    {
        body.motion = Body::Motion::handle;
        body.driver = *drivers.handles.begin();
    }
    else
    {
        if (!drivers.prescribed.empty())
            body.driver = drivers.prescribed.front();
        if (drivers.propagated)
            body.motion = Body::Motion::propagated;
        else if (!drivers.prescribed.empty())
            body.motion = Body::Motion::prescribed;
    }
}

void mark_bodies(VertexRoles& roles, const SurfaceConstraints& constraints)
{
    for (std::size_t k = 0; k < roles.bodies.size(); ++k)
    {
        Body& body = roles.bodies[k];
        const Drivers drivers = drivers_of(body, roles, constraints);
        refuse_contradictions(body, drivers, constraints);
        decide_motion(body, drivers);
        for (const int vertex : body.vertices)
            if (roles.role[at(vertex)] != Role::fixed && roles.role[at(vertex)] != Role::handle)
                set_role(roles, vertex, Role::body, static_cast<int>(k));
    }
}

void require_bodies_on_the_sheet(const VertexRoles& roles, const SurfaceConstraints& constraints)
{
    for (const Body& body : roles.bodies)
    {
        const auto on_sheet = [&](int vertex)
        { return roles.components.label[at(vertex)] != Components::unused; };
        if (!body.is_known() && std::none_of(body.vertices.begin(), body.vertices.end(), on_sheet))
            throw InvalidInput(names_of(body, constraints) + " has only vertices of no triangle: ",
                               body.vertices, "; nothing can move it, remove it");
    }
}

std::vector<char> held_components(const VertexRoles& roles)
{
    std::vector<char> held(at(roles.components.count), 0);
    for (std::size_t i = 0; i < roles.role.size(); ++i)
    {
        const Role role = roles.role[i];
        const bool known = role == Role::fixed || role == Role::handle || role == Role::propagated
                           || (role == Role::body && roles.bodies[at(roles.owner[i])].is_known());
        if (known && roles.components.label[i] != Components::unused)
            held[at(roles.components.label[i])] = 1;
    }
    return held;
}

void require_held_components(VertexRoles& roles, const TriangleMesh& mesh,
                             const SurfaceConstraints& constraints)
{
    const std::vector<char> held = held_components(roles);
    std::vector<char> pointed(held.size(), 0);
    for (const PointConstraint& point : constraints.points)
    {
        const int component = roles.components.label[at(mesh.triangles()(point.triangle, 0))];
        if (component != Components::unused)
            pointed[at(component)] = 1;
    }
    for (int component = 0; component < roles.components.count; ++component)
    {
        if (held[at(component)])
            continue;
        if (!pointed[at(component)])
        {
            throw InvalidInput("nothing holds the component of vertices ",
                               roles.components.vertices(component),
                               "; mark a fixed region or a handle on it, or remove it");
        }
        roles.held_by_points.push_back(component);
    }
}

}  // namespace

VertexRoles assign_roles(const TriangleMesh& mesh, const SurfaceConstraints& constraints)
{
    check_constraints(mesh, constraints);
    VertexRoles roles;
    roles.role.assign(at(mesh.vertex_count()), Role::free);
    roles.owner.assign(at(mesh.vertex_count()), -1);
    roles.bodies = merge_features(mesh, constraints);
    std::vector<VertexIds> joined;
    for (const Body& body : roles.bodies)
        joined.push_back(body.vertices);
    roles.components = connected_components(mesh, joined);
    mark_propagated(roles, constraints);
    mark_fixed(roles, constraints);
    for (std::size_t handle = 0; handle < constraints.handles.size(); ++handle)
        mark_handle(roles, constraints, static_cast<int>(handle));
    mark_bodies(roles, constraints);
    require_bodies_on_the_sheet(roles, constraints);
    require_held_components(roles, mesh, constraints);
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        if (roles.role[i] == Role::free && roles.components.label[i] == Components::unused)
            roles.role[i] = Role::follower;
    return roles;
}

}  // namespace sheetmorph

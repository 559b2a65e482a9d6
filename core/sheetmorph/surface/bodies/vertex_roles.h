// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/geometry/components.h"
#include "sheetmorph/surface/bodies/bodies.h"

namespace sheetmorph::surface
{

enum class Role : char
{
    free,
    fixed,
    handle,
    propagated,
    body,
    tied,     //!< attached to another sheet
    clamped,  //!< for `natural`: next to prescribed vertices, moves rigidly with them
    follower  //!< only of degenerate triangles: moves with the nearest other vertex
};

//! A vertex that moves rigidly with adjacent prescribed vertices, or with their mean.
struct Clamp
{
    struct Carrier
    {
        int vertex;
        double weight;  //!< > 0; the weights add up to 1
    };

    int vertex;
    std::vector<Carrier> carriers;
};

//! The constraint that determines each vertex, with the precedence fixed, handle, feature,
//! propagated.
struct VertexRoles
{
    std::vector<Role> role;
    std::vector<int> owner;  //!< handle, propagated region, body or clamp; else -1
    std::vector<Tie> ties;   //!< of tied vertices
    std::vector<Body> bodies;
    std::vector<Clamp> clamps;  //!< see clamp_neighbours()
    mesh::Components components;

    //! Components that only point constraints support, without prescribed vertices.
    std::vector<int> held_by_points;
};

//! Assigns the roles of all vertices.
//! \throws InvalidInput naming regions and vertices: ids out of range, empty regions, overlapping
//!                      handles, a feature between regions that can move differently, an
//!                      unsupported component
VertexRoles assign_roles(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints);

//! The unsupported components that assign_roles() would refuse; vertices ascending.
//! \throws InvalidInput for all other reasons of assign_roles()
std::vector<VertexIds> unheld_components(const mesh::TriangleMesh& mesh,
                                         const SurfaceConstraints& constraints);

}  // namespace sheetmorph::surface

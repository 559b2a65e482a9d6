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
    tied,     //!< stands on another sheet
    clamped,  //!< `natural`: beside known vertices, moves rigidly with them
    follower  //!< of triangles without area: keeps its place relative to the nearest other one
};

//! A vertex that moves rigidly with known vertices beside it: with their mean where there are more.
struct Clamp
{
    struct Carrier
    {
        int vertex;
        double weight;  //!< > 0, with the sum 1
    };

    int vertex;
    std::vector<Carrier> carriers;
};

//! Which constraint decides each vertex, by the precedence fixed, handle, feature, propagated.
struct VertexRoles
{
    std::vector<Role> role;
    std::vector<int> owner;  //!< handle, propagated region, body or clamp; -1 for the others
    std::vector<Tie> ties;   //!< of tied vertices
    std::vector<Body> bodies;
    std::vector<Clamp> clamps;  //!< see clamp_neighbours()
    mesh::Components components;

    //! Components that no known vertex holds, only points.
    std::vector<int> held_by_points;
};

//! \throws InvalidInput naming regions and vertices: ids out of range, empty regions, handles that
//! overlap, a feature between regions that can move differently, a component that nothing holds
VertexRoles assign_roles(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints);

//! The components that assign_roles() would refuse since nothing holds them; ascending vertices.
//! \throws InvalidInput for anything else that it refuses
std::vector<VertexIds> unheld_components(const mesh::TriangleMesh& mesh,
                                         const SurfaceConstraints& constraints);

}  // namespace sheetmorph::surface

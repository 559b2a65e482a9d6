// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/components.h"
#include "sheetmorph/surface/bodies.h"

namespace sheetmorph
{

enum class Role : char
{
    free,
    fixed,
    handle,
    propagated,
    body,
    follower  //!< in no triangle: keeps its place relative to the nearest triangle
};

//! Which constraint decides each vertex, by the precedence fixed, handle, feature, propagated.
struct VertexRoles
{
    std::vector<Role> role;
    std::vector<int> owner;  //!< handle, propagated region or body; -1 for the others
    std::vector<Body> bodies;
    Components components;

    //! Components that no known vertex holds, only points.
    std::vector<int> held_by_points;
};

//! \throws InvalidInput naming regions and vertices: ids out of range, empty regions, handles that
//! overlap, a feature between regions that can move differently, a component that nothing holds
VertexRoles assign_roles(const TriangleMesh& mesh, const SurfaceConstraints& constraints);

}  // namespace sheetmorph

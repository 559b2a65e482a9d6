// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/vertex_roles.h"
#include "sheetmorph/surface/operators/unknowns.h"

namespace sheetmorph::surface
{

//! Numbers unknowns consecutively; the vertices of a body share one.
class SharedUnknowns
{
public:
    explicit SharedUnknowns(const VertexRoles& roles);

    //! Adds the next vertex: free (with its own or a shared unknown) or prescribed.
    void add(bool is_open);

    Unknowns& found() { return unknowns_; }

private:
    const VertexRoles& roles_;
    std::vector<int> of_body_;
    Unknowns unknowns_;
};

}  // namespace sheetmorph::surface

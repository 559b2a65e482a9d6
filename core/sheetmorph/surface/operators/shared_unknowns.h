// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/vertex_roles.h"
#include "sheetmorph/surface/operators/unknowns.h"

namespace sheetmorph::surface
{

//! Numbers unknowns one after the other: vertices of one body share theirs.
class SharedUnknowns
{
public:
    explicit SharedUnknowns(const VertexRoles& roles);

    //! The next vertex: one with an unknown of its own or one that it shares, or a known one.
    void add(bool is_open);

    Unknowns& found() { return unknowns_; }

private:
    const VertexRoles& roles_;
    std::vector<int> of_body_;
    Unknowns unknowns_;
};

}  // namespace sheetmorph::surface

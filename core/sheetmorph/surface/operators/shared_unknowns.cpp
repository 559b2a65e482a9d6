// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/shared_unknowns.h"

#include "sheetmorph/base/index.h"

namespace sheetmorph::surface
{

SharedUnknowns::SharedUnknowns(const VertexRoles& roles)
    : roles_(roles), of_body_(roles.bodies.size(), Unknowns::known)
{
}

void SharedUnknowns::add(bool is_open)
{
    const std::size_t i = unknowns_.of_vertex.size();
    int unknown = Unknowns::known;
    if (is_open)
    {
        int* shared = &unknown;
        if (roles_.role[i] == Role::body)
            shared = &of_body_[at(roles_.owner[i])];
        if (*shared == Unknowns::known)
            *shared = unknowns_.count++;
        unknown = *shared;
    }
    unknowns_.of_vertex.push_back(unknown);
}

}  // namespace sheetmorph::surface

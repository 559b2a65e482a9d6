// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace sheetmorph
{

//! "1 vertex", "12 vertices": how many there are in a list, for messages.
inline std::string counted_vertices(const std::vector<int>& vertices)
{
    return std::to_string(vertices.size()) + (vertices.size() == 1 ? " vertex" : " vertices");
}

}  // namespace sheetmorph

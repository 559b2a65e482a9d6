// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <algorithm>

namespace sheetmorph
{

//! Sorts vertices and removes duplicates.
inline void make_set(VertexIds& vertices)
{
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

//! Adds vertices to a sorted set.
inline void merge_into(VertexIds& set, const VertexIds& more)
{
    set.insert(set.end(), more.begin(), more.end());
    make_set(set);
}

}  // namespace sheetmorph

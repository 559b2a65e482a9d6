// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cassert>
#include <cstddef>
#include <type_traits>

namespace sheetmorph
{

//! Converts a vertex, facet or row, counted from 0 as a signed number, to the index of a standard
//! container. Do not pass -1, which stands for "none".
template <class Signed>
constexpr std::size_t at(Signed index)
{
    static_assert(std::is_integral_v<Signed> && std::is_signed_v<Signed>,
                  "already an index of a container, or no number to count with");
    assert(index >= 0);
    return static_cast<std::size_t>(index);
}

}  // namespace sheetmorph

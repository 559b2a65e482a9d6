// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace sheetmorph::mesh
{

//! One flag per id in 0 .. count - 1.
using Flags = std::vector<char>;

//! The flags of some ids; ids may be repeated.
//! \throws InvalidInput naming `what` and the ids outside 0 .. count - 1
Flags flags_of(const std::vector<int>& ids, int count, const std::string& what);

//! The ids whose flag has a value, ascending.
std::vector<int> ids_of(const Flags& flags, char value = 1);

}  // namespace sheetmorph::mesh

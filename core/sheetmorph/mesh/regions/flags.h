// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace sheetmorph::mesh
{

//! One flag a member of 0 .. count - 1.
using Flags = std::vector<char>;

//! Set for the ids, which may be repeated.
//! \throws InvalidInput that names `what` and the ids that are not in 0 .. count - 1
Flags flags_of(const std::vector<int>& ids, int count, const std::string& what);

//! The members whose flag has a value, ascending.
std::vector<int> ids_of(const Flags& flags, char value = 1);

}  // namespace sheetmorph::mesh

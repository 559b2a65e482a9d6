// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/system/system.h"

namespace sheetmorph::assembly
{

//! Puts on a sheet what the assembly says about its parts: regions, features and points, groups and
//! pairs, rigid contacts, and what links bring.
//! \param system  with plan, links, welds, pairs and owners
void lay_constraints(const Assembly& assembly, const System& system, Sheet& sheet);

}  // namespace sheetmorph::assembly

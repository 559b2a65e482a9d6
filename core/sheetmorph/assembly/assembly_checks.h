// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"

namespace sheetmorph::assembly
{

//! Checks the entries that belong to no single part.
//! \throws InvalidInput: no part, two entries with one name, a part or primary that does not exist
void check_assembly(const Assembly& assembly);

//! A name for a feature that no feature of the assembly has.
std::string unused_name(const Assembly& assembly, const std::string& wanted);

}  // namespace sheetmorph::assembly

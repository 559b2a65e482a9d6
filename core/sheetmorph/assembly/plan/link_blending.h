// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/link_plan.h"

namespace sheetmorph::assembly
{

//! Contacts of one part that lie beside each other would put neighbours where both cannot be: the
//! sheet folds between them. So every link also wants the vertices of other links of its type that
//! are nearer to its own than a tenth of the smaller of both regions, with weights that fall from 1
//! to 0 over that distance: one contact passes into the other. Where they agree nothing changes.
void blend_neighbours(const Assembly& assembly, std::vector<PlannedLink>& links);

}  // namespace sheetmorph::assembly

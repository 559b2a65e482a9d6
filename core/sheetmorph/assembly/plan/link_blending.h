// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/link_plan.h"

namespace sheetmorph::assembly
{

//! Adjacent contacts of one part could prescribe incompatible positions for neighbouring vertices,
//! and the sheet would fold between them. So every link also prescribes the vertices of other links
//! of its type that are nearer than a tenth of the smaller region. Weights fall from 1 to 0 over
//! that distance, and one contact changes into the other. Where the links agree, nothing changes.
void blend_neighbours(const Assembly& assembly, std::vector<PlannedLink>& links);

}  // namespace sheetmorph::assembly

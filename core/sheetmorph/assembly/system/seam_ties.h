// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/propagation_plan.h"
#include "sheetmorph/assembly/system/seams.h"

namespace sheetmorph::assembly
{

//! By part: its place among all, the coarsest first; as fine ones by name. In contacts finer parts
//! stand on coarser ones, so that which part is the primary, or which side is told first, does not
//! matter.
std::vector<int> ranks_by_fineness(const Assembly& assembly);

//! Lets the coarser part be the source of every contact that is measured.
void lead_by_coarser(const Assembly& assembly, const std::vector<int>& ranks,
                     PropagationPlan& plan);

//! Every vertex of a target stands on the nearest source, but for rigid ones, and corners of the
//! triangles of points. Where it stands on another part already, and that not on this one, the
//! source stands on the target.
//! \param sheet  with its stitches
//! \returns      such that the ties of its corners come before a tie
std::vector<surface::Tie> tied(const Sheet& sheet, const std::vector<Seam>& seams);

}  // namespace sheetmorph::assembly

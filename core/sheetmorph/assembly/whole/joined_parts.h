// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/link_plan.h"
#include "sheetmorph/assembly/whole/seam_ties.h"

namespace sheetmorph::assembly
{

//! All parts that are reached as one part of several sheets, so that one solve answers all of them:
//! what is held anywhere holds, and motion goes both ways. Stacks of rigid contacts are form
//! features of it, other contacts stitches (seams.h) and ties (seam_ties.h); nothing else is left
//! of the contacts.
struct JoinedParts
{
    Assembly assembly;          //!< of one part
    std::vector<int> first;     //!< by part: its first vertex there; -1: nothing reaches it
    std::vector<int> features;  //!< by feature of the assembly: that of the one part, or -1
    int welds = 0;              //!< the feature there of the first weld; the others follow
};

//! \param plan    lead_by_coarser()
//! \param welds   plan_welds()
//! \param places  by measured contact; empty for rigid ones
JoinedParts joined_parts(const Assembly& assembly, const PropagationPlan& plan,
                         const std::vector<RigidWeld>& welds,
                         const std::vector<SeamPlaces>& places);

}  // namespace sheetmorph::assembly

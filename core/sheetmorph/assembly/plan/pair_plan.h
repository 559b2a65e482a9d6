// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/propagation_plan.h"

namespace sheetmorph::assembly
{

//! A pair of form features with the one that leads: of two parts that are deformed one after the
//! other the feature of the earlier one, else the first.
struct PlannedPair
{
    std::string name;
    surface::FeatureLinkType type = surface::FeatureLinkType::coaxial;
    int leader = 0;  //!< index into Assembly::features
    int follower = 0;
    Vector3 centre = Vector3::Zero();      //!< a point of the leader's axis, or its centre, mm
    Vector3 direction = Vector3::UnitZ();  //!< of the leader's axis
    std::vector<Subject> of = {};          //!< the entries of the assembly that it stands for
};

//! Pairs between features of parts that are reached.
//! \throws InvalidInput naming features that are not coaxial at rest (by how many mm and degrees),
//! that have no axis, or no distance
std::vector<PlannedPair> plan_pairs(const Assembly& assembly, const PropagationPlan& plan);

}  // namespace sheetmorph::assembly

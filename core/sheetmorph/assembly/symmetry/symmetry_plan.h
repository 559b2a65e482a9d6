// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/symmetry/mirror.h"

#include <utility>

namespace sheetmorph::assembly
{

//! Pairs of entries that mirror each other; (k, k) is its own mirror.
struct SymmetryPlan
{
    std::vector<std::pair<int, int>> handles;
    std::vector<std::pair<int, int>> features;
    std::vector<std::pair<int, int>> points;
    std::vector<Vector3> places;  //!< by point: position at rest, mm
};

//! Completes an assembly that has a plane of symmetry. Adds the missing entries of either side as
//! "(mirrored)": handles, points, form features, fixed regions, and groups and pairs of features.
//! Fixed regions, and features that only keep their form, may lack a mirror.
//! \throws InvalidInput naming an entry without a mirror, or one that both sides declare
//!     differently
SymmetryPlan complete_by_symmetry(Assembly& assembly);

//! The pose for both sides of the plane. An entry that moves on one side also moves on the other,
//! mirrored. An entry that is its own mirror keeps the symmetric part of its motion.
//! \throws InvalidInput naming two entries that the pose moves differently
Pose symmetric_pose(const Assembly& assembly, const SymmetryPlan& plan, Pose pose);

}  // namespace sheetmorph::assembly

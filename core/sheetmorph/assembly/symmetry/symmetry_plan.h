// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/symmetry/mirror.h"

#include <utility>

namespace sheetmorph::assembly
{

//! Which entries of an assembly mirror each other; (k, k): its own mirror.
struct SymmetryPlan
{
    std::vector<std::pair<int, int>> handles;
    std::vector<std::pair<int, int>> features;
    std::vector<std::pair<int, int>> points;
    std::vector<Vector3> places;  //!< by point: where it is at rest, mm
};

//! Adds to an assembly with a plane of symmetry what it lacks on either side, called "(mirrored)":
//! handles, points, form features, fixed regions, and the groups and pairs of features.
//! Features that only keep their form, and fixed regions, may be without a mirror.
//! \throws InvalidInput naming what has no mirror, or what is declared differently on both sides
SymmetryPlan complete_by_symmetry(Assembly& assembly);

//! The pose with both sides of the plane told: what it moves on one side alone moves on the other
//! too; what is its own mirror keeps the symmetric part of its motion.
//! \throws InvalidInput naming two entries that the pose moves differently
Pose symmetric_pose(const Assembly& assembly, const SymmetryPlan& plan, Pose pose);

}  // namespace sheetmorph::assembly

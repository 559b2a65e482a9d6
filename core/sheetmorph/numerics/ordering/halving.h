// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::numerics
{

//! Reorders a range of rows of `places` so that a plane across the longest side of their box
//! separates the rows before `middle` from the others. The plane leans a little, so that it cuts
//! walls across that side along a line. Rounding would divide such a wall along an upright plane.
//! Equal places are ordered by number, so the halves do not depend on the previous order.
void halve(VertexIds::iterator begin, VertexIds::iterator middle, VertexIds::iterator end,
           const Points& places);

//! Reorders rows of `places` into groups that are close together; ascending within a group.
void group_by_place(VertexIds& rows, const Points& places, Eigen::Index rows_a_group);

}  // namespace sheetmorph::numerics

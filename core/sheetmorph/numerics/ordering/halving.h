// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::numerics
{

//! Reorders a range of rows of `places`, so that those before `middle` lie on one side of a plane
//! across the longest side of the box around all, and the others beyond it. The plane leans a
//! little, so that it cuts walls that stand across that side along a line: upright it would part
//! their places by rounding. Equal places go by their numbers, so that the halves do not depend on
//! the order before.
void halve(VertexIds::iterator begin, VertexIds::iterator middle, VertexIds::iterator end,
           const Points& places);

//! Reorders rows of `places`, so that each group of them lies close together; ascending within a
//! group.
void group_by_place(VertexIds& rows, const Points& places, Eigen::Index rows_a_group);

}  // namespace sheetmorph::numerics

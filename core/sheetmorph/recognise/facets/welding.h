// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::recognise
{

//! For every point the smallest index of a point that is, over others perhaps,
//! within `distance` of it; the index itself where it stands alone. \param
//! points  (n, 3) mm
std::vector<int> coincident(const Points& points, double distance);

}  // namespace sheetmorph::recognise

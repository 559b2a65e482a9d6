// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::recognise
{

//! Clusters of coincident points. Points within `distance` (mm) of each other, also through a chain
//! of others, form a cluster.
//! \param points  (n, 3) mm
//! \returns       for every point, the smallest index in its cluster
std::vector<int> coincident(const Points& points, double distance);

}  // namespace sheetmorph::recognise

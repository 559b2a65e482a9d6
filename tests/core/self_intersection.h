// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::shapes
{

//! Whether two triangles of a closed manifold mesh meet anywhere but in what they share, by CGAL.
bool intersects_itself(const Points& points, const Triangles& triangles);

}  // namespace sheetmorph::shapes

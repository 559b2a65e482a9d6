// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/rim_profile.h"
#include "sheetmorph/fitting/surface.h"

namespace sheetmorph
{

//! The cylinder that all corners of the facets lie on within 2 % of its radius, if there is one and
//! the facets go around enough of it (30 degrees) to tell.
std::optional<RimProfile> fit_cylinder(const FacetSample& facets);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/rim_profile.h"
#include "sheetmorph/fitting/surface.h"

namespace sheetmorph::fitting
{

//! The cylinder through all corners of the facets. Returns nothing if a corner deviates by more
//! than 2 % of the radius, or if the facets cover less than 30 degrees of arc.
std::optional<RimProfile> fit_cylinder(const FacetSample& facets);

}  // namespace sheetmorph::fitting

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/surfaces/surfaces.h"

namespace sheetmorph::recognise
{

//! Bends of sheet metal: cylindrical strips that continue smoothly into a flat at either end and
//! turn by at most 198 degrees. `radius` is the inner radius, `angle` the total turn (radians),
//! `length` the extent along the axis. In a solid, both skins form one bend and `depth` is the
//! thickness. A rounding with a single surface (a rounded edge or corner, the end of a slot) is not
//! a bend.
//! Vertices refer to the merged mesh.
std::vector<Feature> find_bends(const FacetGraph& graph, const std::vector<SurfaceRegion>& surfaces,
                                const FeatureTolerances& tolerances);

}  // namespace sheetmorph::recognise

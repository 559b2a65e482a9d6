// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/surfaces/surfaces.h"

namespace sheetmorph::recognise
{

//! The flanges of a sheet: strips with a fold (a crease or a bend) on one side and a free edge on
//! the other, longer than wide. A solid has no flanges. Vertices refer to the merged mesh.
std::vector<Feature> find_flanges(const FacetGraph& graph,
                                  const std::vector<SurfaceRegion>& surfaces,
                                  const FeatureTolerances& tolerances);

//! The raised and sunk regions inside large planes, with or without a sharp edge: beads (at least
//! twice as long as wide) and embosses. Vertices refer to the merged mesh.
std::vector<Feature> find_embosses(const FacetGraph& graph,
                                   const std::vector<SurfaceRegion>& surfaces,
                                   const FeatureTolerances& tolerances);

}  // namespace sheetmorph::recognise

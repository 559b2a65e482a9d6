// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/surfaces/surfaces.h"

namespace sheetmorph::recognise
{

//! The flanges of a sheet: strips with a fold (a crease or a bend) on one side
//! and a free edge on the other, longer than wide. A solid has none. Vertices
//! of the welded mesh.
std::vector<Feature> find_flanges(const FacetGraph& graph,
                                  const std::vector<SurfaceRegion>& surfaces,
                                  const FeatureTolerances& tolerances);

//! The places inside large planes that rise above them or sink below, without a
//! sharp edge perhaps: beads (at least twice as long as wide) and embosses.
//! Vertices of the welded mesh.
std::vector<Feature> find_embosses(const FacetGraph& graph,
                                   const std::vector<SurfaceRegion>& surfaces,
                                   const FeatureTolerances& tolerances);

}  // namespace sheetmorph::recognise

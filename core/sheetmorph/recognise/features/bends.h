// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/surfaces/surfaces.h"

namespace sheetmorph::recognise
{

//! The bends of sheet metal: cylindrical strips, less than a full turn, that go on straight on into
//! a flat at either end. `radius` is the inner one, `angle` how far the sheet turns (radians),
//! `length` along the axis. Of a solid both skins are one bend, `depth` the thickness between them;
//! a rounding with a single surface (an edge, a corner of the outline, the end of a slot) is none.
//! Vertices of the welded mesh.
std::vector<Feature> find_bends(const FacetGraph& graph, const std::vector<SurfaceRegion>& surfaces,
                                const FeatureTolerances& tolerances);

}  // namespace sheetmorph::recognise

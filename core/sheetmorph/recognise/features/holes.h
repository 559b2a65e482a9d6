// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"
#include "sheetmorph/recognise/feature.h"
#include "sheetmorph/recognise/tolerances.h"

namespace sheetmorph::recognise
{

//! Finds holes, round edges, and sharp-edged beads and embosses from the closed creases and free
//! rims of a part. Vertices refer to the merged mesh.
//! A loop is the rim of a hole if its region surrounds it and one of these is inside it: nothing (a
//! free rim), a wall that ends at a free rim (a collar), or a wall that leads to another skin (a
//! thin solid). A closed bottom makes it a blind hole in a solid, and a bead or an emboss in a
//! sheet.
std::vector<Feature> find_rims(const FacetGraph& graph, const FeatureTolerances& tolerances);

}  // namespace sheetmorph::recognise

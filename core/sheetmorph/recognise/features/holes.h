// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/facets/facet_graph.h"
#include "sheetmorph/recognise/feature.h"
#include "sheetmorph/recognise/tolerances.h"

namespace sheetmorph::recognise
{

//! The holes, round edges and sharp-edged beads and embosses of a part: what
//! closed lines in the surface and closed rims of the mesh stand for. Vertices
//! are those of the welded mesh.
//!
//! A line is the rim of a hole if its region lies around it, and what is inside
//! it either is nothing (a free rim), ends at a free rim (a collar) or leads to
//! another skin (a thin solid). A closed bottom makes it a blind hole in a
//! solid, a bead or an emboss in a sheet.
std::vector<Feature> find_rims(const FacetGraph& graph, const FeatureTolerances& tolerances);

}  // namespace sheetmorph::recognise

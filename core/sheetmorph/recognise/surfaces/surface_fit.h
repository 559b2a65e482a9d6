// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/surface.h"
#include "sheetmorph/recognise/facets/facet_graph.h"

namespace sheetmorph::recognise
{

//! Smallest cosine between a triangle's normal and that of its curved surface, 30 degrees. From
//! geometry: a facet deviates by half the bend to the next one at most, and smooth_angle of
//! FeatureTolerances allows 52 degrees between facets.
constexpr double along_surface = 0.866;

//! The sample of triangles that a surface is fitted to.
fitting::FacetSample sample_of(const FacetGraph& graph, const std::vector<int>& triangles);

//! (k, 3) corners of a subset of the triangles; enough to refine a surface.
Points some_corners(const FacetGraph& graph, const std::vector<int>& triangles);

//! The largest distance of a corner of the triangles from the surface, relative to the radius
//! there.
double misfit_of(const FacetGraph& graph, const std::vector<int>& triangles,
                 const fitting::Surface& surface);

}  // namespace sheetmorph::recognise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/feature.h"
#include "sheetmorph/recognise/surfaces/surface_fit.h"
#include "sheetmorph/recognise/tolerances.h"

namespace sheetmorph::recognise
{

//! A surface and its triangles, ascending.
struct SurfaceRegion
{
    fitting::Surface surface;
    std::vector<int> triangles;
    double area = 0.0;             //!< mm^2
    Convergence convergence = {};  //!< of the alternation of growing and fitting
};

//! Finds the planes, cylinders, spheres and cones of a part by region growing (see
//! surface_grower.h). Regions do not overlap.
std::vector<SurfaceRegion> find_surfaces(const FacetGraph& graph,
                                         const FeatureTolerances& tolerances);

//! The feature of a region. Vertices refer to the merged mesh.
Feature feature_of(const FacetGraph& graph, const SurfaceRegion& region);

}  // namespace sheetmorph::recognise

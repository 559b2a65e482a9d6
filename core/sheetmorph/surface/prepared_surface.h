// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/feature_responses.h"
#include "sheetmorph/surface/followers.h"
#include "sheetmorph/surface/refinement.h"
#include "sheetmorph/surface/sheet_growth.h"
#include "sheetmorph/surface/unknowns.h"

namespace sheetmorph
{

//! Everything about one part that no pose changes. Its members refer to each other, so it stays
//! where it is made.
struct PreparedSurface
{
    PreparedSurface(const TriangleMesh& rest_mesh, const SurfaceConstraints& given,
                    const Progress& progress);
    PreparedSurface(const PreparedSurface&) = delete;
    PreparedSurface& operator=(const PreparedSurface&) = delete;

    PlacementInput placement() const { return {rest, constraints, roles}; }

    TriangleMesh rest;
    SurfaceConstraints constraints;
    VertexRoles roles;
    FeatureShapes shapes;
    SurfaceOperators operators;
    Unknowns unknowns;
    std::unique_ptr<RotationField> field;
    ConstrainedMinimiser minimiser;
    std::unique_ptr<FeatureResponses> responses;  //!< none where the energy turns nothing
    std::unique_ptr<Refinement> refinement;       //!< none unless it is asked for
    SheetGrowth growth;
    Followers followers;
};

}  // namespace sheetmorph

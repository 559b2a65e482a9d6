// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/features/feature_responses.h"
#include "sheetmorph/surface/operators/followers.h"
#include "sheetmorph/surface/operators/unknowns.h"
#include "sheetmorph/surface/rotation/far_turns.h"
#include "sheetmorph/surface/solve/sheet_growth.h"
#include "sheetmorph/surface/steel/steel_answer.h"

namespace sheetmorph::surface
{

//! Everything about one part that no pose changes. Its members refer to each other, so it stays
//! where it is made.
struct PreparedSurface
{
    //! \param earlier  an earlier state of a part: if the mesh is the same, what the constraints do
    //!                 not change is taken over
    PreparedSurface(const mesh::TriangleMesh& rest_mesh, const SurfaceConstraints& given,
                    const Progress& progress, const PreparedSurface* earlier);
    PreparedSurface(const PreparedSurface&) = delete;
    PreparedSurface& operator=(const PreparedSurface&) = delete;

    PlacementInput placement() const { return {rest, constraints, roles}; }

    mesh::TriangleMesh rest;
    SurfaceConstraints constraints;
    VertexRoles roles;
    FeatureShapes shapes;
    std::shared_ptr<const SurfaceOperators> shared_operators;  //!< with other states of the part
    const SurfaceOperators& operators;
    Unknowns unknowns;
    std::unique_ptr<RotationField> field;
    std::unique_ptr<const FarTurns> far_turns;  //!< of `natural` alone
    numerics::ConstrainedMinimiser minimiser;
    std::unique_ptr<FeatureResponses> responses;  //!< none where the energy turns nothing
    std::unique_ptr<SteelAnswer> steel;           //!< none but for `steel` and refined parts
    SheetGrowth growth;
    Followers followers;

private:
    struct Reuse
    {
        const PreparedSurface* earlier;  // with the same operators
    };
    PreparedSurface(const mesh::TriangleMesh& rest_mesh, const SurfaceConstraints& given,
                    const Progress& progress, Reuse reuse);
};

}  // namespace sheetmorph::surface

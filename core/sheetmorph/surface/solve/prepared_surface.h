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

//! All data of one part that are independent of the pose. Members refer to each other, so the
//! object cannot move.
struct PreparedSurface
{
    //! \param earlier  an earlier state of the part; with the same mesh, reuses all data that the
    //!                 constraints do not change
    PreparedSurface(const mesh::TriangleMesh& rest_mesh, const SurfaceConstraints& given,
                    const Progress& progress, const PreparedSurface* earlier);
    PreparedSurface(const PreparedSurface&) = delete;
    PreparedSurface& operator=(const PreparedSurface&) = delete;

    PlacementInput placement() const { return {rest, constraints, roles}; }

    mesh::TriangleMesh rest;
    SurfaceConstraints constraints;
    VertexRoles roles;
    FeatureShapes shapes;
    std::shared_ptr<const SurfaceOperators> shared_operators;  //!< shared with other states
    const SurfaceOperators& operators;
    Unknowns unknowns;
    std::unique_ptr<RotationField> field;
    std::unique_ptr<const FarTurns> far_turns;  //!< only for `natural`
    numerics::ConstrainedMinimiser minimiser;
    std::unique_ptr<FeatureResponses> responses;  //!< nullptr without rotating bodies
    std::unique_ptr<SteelAnswer> steel;           //!< only for `steel` and refined parts
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

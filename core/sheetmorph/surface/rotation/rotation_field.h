// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/surface/bodies/body_motions.h"
#include "sheetmorph/surface/operators/surface_operators.h"

#include <memory>

namespace sheetmorph::surface
{

//! Rotation logarithms of a whole sheet.
struct SpreadRotations
{
    Points logs;                   //!< (n, 3)
    Convergence convergence = {};  //!< where they were solved for in rounds
};

//! Spreads known rotations over the sheet (2.7 to 2.9); interpolated features get one rotation
//! each. Where nothing on a component is turned or held, its rotation is none.
class RotationField
{
public:
    virtual ~RotationField() = default;

    virtual SpreadRotations spread(const KnownRotations& known) const = 0;

    //! (n, 3) the same rotations spread evenly, without regard to slopes where they are known: the
    //! harmonic interpolant (2.7) itself.
    virtual Points harmonic(const KnownRotations& known) const = 0;
};

//! What both kinds of field are made from; only read during construction.
struct RotationFieldInput
{
    const mesh::TriangleMesh& mesh;
    const SurfaceConstraints& constraints;
    const VertexRoles& roles;
    const SurfaceOperators& operators;
};

//! `paper`: (2.9) as printed: unweighted, all rows, biharmonic, one unknown a feature.
//! \param earlier  of the same operators under other constraints: what does not change is taken
//! over
std::unique_ptr<RotationField> biharmonic_rotation_field(const RotationFieldInput& input,
                                                         const RotationField* earlier = nullptr);

//! `neumann`: harmonic weights of what is known (2.7), passed through 3 w^2 - 2 w^3, renormalised:
//! between the known rotations everywhere, flat where they are given, no overshoot.
//! \param earlier  of the same operators under other constraints: what does not change is taken
//! over
std::unique_ptr<RotationField> blended_rotation_field(const RotationFieldInput& input,
                                                      const RotationField* earlier = nullptr);

//! Whether a vertex's rotation comes with the pose: fixed, handle, propagated, or on a body whose
//! rotation does.
bool is_rotation_known(const VertexRoles& roles, int vertex);

}  // namespace sheetmorph::surface

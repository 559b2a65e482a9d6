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
    Convergence convergence = {};  //!< if the solution is iterative
};

//! Interpolates prescribed rotations over the sheet (2.7 to 2.9). An interpolated feature gets one
//! rotation. A component without prescribed rotations does not rotate.
class RotationField
{
public:
    virtual ~RotationField() = default;

    virtual SpreadRotations spread(const KnownRotations& known) const = 0;

    //! (n, 3) the harmonic interpolant (2.7) of the same rotations, without zero slopes at
    //! prescribed vertices.
    virtual Points harmonic(const KnownRotations& known) const = 0;
};

//! Input of both kinds of field; only read during construction.
struct RotationFieldInput
{
    const mesh::TriangleMesh& mesh;
    const SurfaceConstraints& constraints;
    const VertexRoles& roles;
    const SurfaceOperators& operators;
};

//! `paper`: (2.9) as printed: unweighted, all rows, biharmonic, one unknown per feature.
//! \param earlier  a field of the same operators under other constraints; reuses all unchanged data
std::unique_ptr<RotationField> biharmonic_rotation_field(const RotationFieldInput& input,
                                                         const RotationField* earlier = nullptr);

//! `neumann`: harmonic weights of the prescribed rotations (2.7), mapped by 3 w^2 - 2 w^3 and
//! renormalised. The result has zero slope at prescribed vertices and no overshoot.
//! \param earlier  a field of the same operators under other constraints; reuses all unchanged data
std::unique_ptr<RotationField> blended_rotation_field(const RotationFieldInput& input,
                                                      const RotationField* earlier = nullptr);

//! Whether the pose determines a vertex's rotation: fixed, handle, propagated, or on a body with a
//! prescribed rotation.
bool is_rotation_known(const VertexRoles& roles, int vertex);

}  // namespace sheetmorph::surface

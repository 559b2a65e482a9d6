// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/turners.h"
#include "sheetmorph/surface/rotation/rotation_field.h"
#include "sheetmorph/surface/rotation/smooth_weights.h"

namespace sheetmorph::surface
{

//! The influence of each rotating body on the sheet's rotation at each vertex (mathematics.md,
//! section 4). Harmonic weights w are 1 on the body and 0 on the others and on prescribed
//! rotations. Each is mapped by 3 w^2 - 2 w^3, and all are renormalised together with the share of
//! the rotation field. Weights below 1e-3 vanish, so that distant features do not interact.
//! \returns (n, rotating bodies); bodies whose rotation is not free have no weights
SmoothWeights turner_weights(const RotationFieldInput& input, const std::vector<Turner>& turners);

}  // namespace sheetmorph::surface

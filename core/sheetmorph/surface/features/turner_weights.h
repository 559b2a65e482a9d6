// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/turners.h"
#include "sheetmorph/surface/rotation/rotation_field.h"
#include "sheetmorph/surface/rotation/smooth_weights.h"

namespace sheetmorph::surface
{

//! How far the sheet at a vertex turns with each turner (mathematics.md, section 4): harmonic
//! weights w, one on the turner, zero on the others and wherever the rotation is known, each
//! passed through 3 w^2 - 2 w^3 and renormalised together with what is left to the rotation field.
//! Weights fade to none at 1e-3, so that distant features do not meet.
//! \returns of (n, turners); turners that do not turn have none
SmoothWeights turner_weights(const RotationFieldInput& input, const std::vector<Turner>& turners);

}  // namespace sheetmorph::surface

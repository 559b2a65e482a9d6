// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! A logarithm of a rotation near `reference`. It is continuous in both, also where the reference
//! passes whole turns, as long as the rotation is less than half a turn from the reference's.
//! It is exact if the rotation is more than 126 degrees from a whole turn, or the reference below
//! 180 degrees. Near a whole turn, a tilt has no logarithm nearby, because the branches of
//! log_from_rotation() jump there. The result then has the reference's axis and the rotation's
//! angle about it, and the tilt is damped. The reference's own rotation gives the reference.
Vector3 log_near(const Matrix3& rotation, const Vector3& reference);

//! The part of a rotation that its log_near() misses: R = exp(tilt) exp(log), as a log. Exactly
//! zero if the log misses only rounding.
Vector3 tilt_beyond(const Matrix3& rotation, const Vector3& log);

//! The rotation of a log and a tilt: exp(tilt) exp(log).
Matrix3 tilted_rotation(const Vector3& log, const Vector3& tilt);

//! nearest_rotation() by Newton's iteration, ten times faster for matrices near a rotation.
Matrix3 polar_rotation(const Matrix3& matrix);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! A logarithm of a rotation near `reference`, continuous in both as long as the rotation is less
//! than half a turn from the reference's: also where the reference passes whole turns.
//! Exact while the rotation is more than 126 degrees from a whole turn, or the reference below 180.
//! Near a whole turn a tilt has no logarithm nearby (branches of log_from_rotation() jump there):
//! what is returned then turns about the reference's axis as far as the rotation does, and its tilt
//! is damped. A rotation equal to the reference's gives the reference.
Vector3 log_near(const Matrix3& rotation, const Vector3& reference);

//! What a log of log_near() cannot tell of the rotation: R = exp(tilt) exp(log), as a log itself.
//! Zero, exactly, where the log tells all but rounding.
Vector3 tilt_beyond(const Matrix3& rotation, const Vector3& log);

//! The rotation of a log and a tilt.
Matrix3 tilted_rotation(const Vector3& log, const Vector3& tilt);

//! nearest_rotation() by Newton's iteration, ten times faster for matrices near a rotation.
Matrix3 polar_rotation(const Matrix3& matrix);

}  // namespace sheetmorph

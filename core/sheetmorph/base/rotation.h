// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! [a]x, the matrix of the cross product: [a]x b = a x b.
Matrix3 cross_matrix(const Vector3& a);

//! Quaternion logarithm r = (theta / 2) v of a rotation by `radians` about `axis` (2.6). Keeps
//! angles beyond half a turn and beyond a full one.
//! \throws InvalidInput if the axis has no length or a value is not finite, unless radians = 0
Vector3 rotation_log(const Vector3& axis, double radians);

//! Rotation about r / |r| by the angle 2 |r| (2.5); exactly the identity for r = 0.
Matrix3 rotation_from_log(const Vector3& log);

//! The logarithm of a rotation matrix with the smallest angle.
Vector3 log_from_rotation(const Matrix3& rotation);

//! The logarithm of the same rotation that is nearest to `reference`.
Vector3 nearest_branch(const Vector3& log, const Vector3& reference);

//! The rotation nearest to a matrix (polar factor, det = +1).
Matrix3 nearest_rotation(const Matrix3& matrix);

}  // namespace sheetmorph

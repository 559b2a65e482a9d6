// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! The rotation about an axis (unit length) contained in a rotation (swing-twist decomposition);
//! the identity if it is undefined.
Matrix3 twist_about(const Matrix3& rotation, const Vector3& axis);

//! The motion nearest to `wanted` that the body's FeatureMotion allows.
BodyState nearest_restricted(const PlacementInput& part, const Body& body, const BodyState& wanted);

//! The motion nearest to `wanted` that the body's link allows.
//! \param leader  state of the leading body; its centre is the moved Following::centre
BodyState nearest_following(const PlacementInput& part, const Body& body, const BodyState& leader,
                            const BodyState& wanted);

//! The state of a body that moves rigidly with its leader.
BodyState carried_along(const Body& body, const BodyState& leader);

//! The deformed position of a point of a body at rest.
Vector3 moved_point(const Body& body, const BodyState& state, const Vector3& point);

}  // namespace sheetmorph::surface

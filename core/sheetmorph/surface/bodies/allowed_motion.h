// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/body_motions.h"

namespace sheetmorph::surface
{

//! The part of a rotation that is about an axis of unit length (swing-twist); the identity where
//! it is not defined.
Matrix3 twist_about(const Matrix3& rotation, const Vector3& axis);

//! Of what a body's FeatureMotion allows, the motion nearest to a wanted one.
BodyState nearest_restricted(const PlacementInput& part, const Body& body, const BodyState& wanted);

//! Of what a body's link allows, the motion nearest to a wanted one.
//! \param leader  where the leading body is; its centre that of Following::centre moved
BodyState nearest_following(const PlacementInput& part, const Body& body, const BodyState& leader,
                            const BodyState& wanted);

//! A body moved as one with its leader.
BodyState carried_along(const Body& body, const BodyState& leader);

//! Where a point of a body at rest is now.
Vector3 moved_point(const Body& body, const BodyState& state, const Vector3& point);

}  // namespace sheetmorph::surface

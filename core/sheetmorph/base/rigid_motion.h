// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! A turn about a pivot, then a shift: p -> pivot + translation + R (p - pivot).
//! What a pose stores for a handle: the angle is kept beyond half a turn.
struct RigidMotion
{
    Vector3 translation = Vector3::Zero();   //!< mm
    Vector3 rotation_log = Vector3::Zero();  //!< (theta / 2) v (2.6), radians
    Vector3 pivot = Vector3::Zero();         //!< mm

    Matrix3 rotation() const;

    //! Returns p itself, bit for bit, if the motion is none; p + translation if it does not turn.
    Vector3 apply(const Vector3& point) const;

    //! Rows of `points` moved.
    Points apply(const Points& points) const;
};

//! The rigid motion that best takes rows of `from` to rows of `to` (least squares, weights >= 0,
//! empty for equal ones). Straight and single-point sets take the smallest turn that does it.
RigidMotion best_rigid_motion(const Points& from, const Points& to,
                              const Eigen::VectorXd& weights = {});

//! Stiffness of the known rotation against points that spread little across it. Chosen: as if every
//! point had offsets of a thirtieth (the root of this) of the extent. A narrower set does not show
//! its own rotation about its length.
constexpr double stiffness_of_known_rotation = 1e-3;

//! The same where a rotation is already known approximately: what the points tell weakly or not at
//! all (a straight row, a narrow strip, a single point) stays as `rotation_log` says.
//! Exactly the motion for points that move rigidly by that rotation. Its log is near the given one.
RigidMotion best_rigid_motion_near(const Points& from, const Points& to,
                                   const Vector3& rotation_log);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! A rotation about a pivot, then a translation: p -> pivot + translation + R (p - pivot). A pose
//! stores one per handle; its angle may exceed half a turn.
struct RigidMotion
{
    Vector3 translation = Vector3::Zero();   //!< mm
    Vector3 rotation_log = Vector3::Zero();  //!< (theta / 2) v (2.6), radians
    Vector3 pivot = Vector3::Zero();         //!< mm

    Matrix3 rotation() const;

    //! Returns p itself, bit for bit, for the identity, and p + translation without a rotation.
    Vector3 apply(const Vector3& point) const;

    //! Applies the motion to each row.
    Points apply(const Points& points) const;
};

//! The rigid motion that best takes the rows of `from` to the rows of `to`, by least squares. For
//! collinear points and single points, the smallest rotation that does it.
//! \param weights  (n), >= 0; empty for equal ones
RigidMotion best_rigid_motion(const Points& from, const Points& to,
                              const Eigen::VectorXd& weights = {});

//! Stiffness of the known rotation against points that spread little across it. Chosen: as if every
//! point had offsets of a thirtieth (the root of this) of the extent. A narrower set does not show
//! its own rotation about its length.
constexpr double stiffness_of_known_rotation = 1e-3;

//! The same if a rotation is already known approximately. Where the points determine the rotation
//! weakly or not at all (a straight row, a narrow strip, a single point), `rotation_log` decides.
//! Exact for points that move rigidly by that rotation. The log of the result is near the given
//! one.
RigidMotion best_rigid_motion_near(const Points& from, const Points& to,
                                   const Vector3& rotation_log);

}  // namespace sheetmorph

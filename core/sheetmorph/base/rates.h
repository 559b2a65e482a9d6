// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"

#include <stdexcept>

namespace sheetmorph
{

//! An answer is not differentiated in this pose, or with these constraints; the text says why.
class NoDerivative : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

//! [a]x: [a]x b = a x b.
Matrix3 cross_matrix(const Vector3& a);

//! How a rotation R changes along one direction of the pose is its spin s, with dR = [s]x R.
//! \param log, rate  of R (2.6), radians: half the angle
Vector3 spin_of_log(const Vector3& log, const Vector3& rate);

//! The other way round. \throws NoDerivative near whole turns, where logs have none
Vector3 log_rate_of_spin(const Vector3& log, const Vector3& spin);

//! Of the rotation that is nearest to a matrix, its polar factor. \param rate  of the matrix
Vector3 spin_of_polar(const Matrix3& rotation, const Matrix3& matrix, const Matrix3& rate);

//! \throws NoDerivative where log_near() damps: near a whole turn a log does not tell all of its
//! rotation
void require_whole_log(const Matrix3& rotation, const Vector3& log);

//! How a rigid motion changes along one direction of the pose.
struct MotionRate
{
    Vector3 shift = Vector3::Zero();  //!< of the translation, mm
    Vector3 log = Vector3::Zero();    //!< of the rotation log, radians
    Vector3 pivot = Vector3::Zero();  //!< of the pivot, mm
    Vector3 spin = Vector3::Zero();   //!< of the rotation: that of the log

    //! How a point that moves with the motion changes its place, mm. \param point  at rest
    Vector3 at(const RigidMotion& motion, const Vector3& point) const;

    //! The same change told of the motion about another, unmoved centre.
    MotionRate about(const RigidMotion& motion, const Vector3& centre) const;
};

//! A rotation with how it changes.
struct Turning
{
    Matrix3 rotation = Matrix3::Identity();
    Vector3 spin = Vector3::Zero();
};

//! Of best_rigid_motion_near(): its spin, where the targets change by `rates` (k, 3) and the known
//! rotation turns.
Vector3 best_motion_spin(const Points& from, const Points& to, const Points& rates,
                         const Turning& known);

}  // namespace sheetmorph

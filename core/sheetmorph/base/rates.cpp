// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rates.h"

#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"

#include <Eigen/Dense>
#include <cmath>

namespace sheetmorph
{

namespace
{

constexpr double pi = 3.14159265358979323846;

// Half angles beyond which log_near() may damp, and rotations for which it does.
constexpr double half_turn = 0.5 * pi;
constexpr double axisless = 0.35 * pi;

[[noreturn]] void refuse_whole_turns()
{
    throw NoDerivative("a sheet is turned by about a whole turn, where its rotation has no axis");
}

// a of a skew matrix [a]x.
Vector3 axial(const Matrix3& skew)
{
    return 0.5 * Vector3(skew(2, 1) - skew(1, 2), skew(0, 2) - skew(2, 0), skew(1, 0) - skew(0, 1));
}

}  // namespace

Matrix3 cross_matrix(const Vector3& a)
{
    Matrix3 matrix;
    matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return matrix;
}

Vector3 spin_of_log(const Vector3& log, const Vector3& rate)
{
    return 2.0 * (left_jacobian(log) * rate);
}

Vector3 log_rate_of_spin(const Vector3& log, const Vector3& spin)
{
    if (spin.isZero(0.0))
        return Vector3::Zero();
    if (log.norm() > half_turn + axisless)
        refuse_whole_turns();
    return 0.5 * (left_jacobian(log).inverse() * spin);
}

// With M = R S, S symmetric, and dR = R [w]x: R^T dM - dM^T R = [w]x S + S [w]x, which is
// [(tr S - S) w]x.
Vector3 spin_of_polar(const Matrix3& rotation, const Matrix3& matrix, const Matrix3& rate)
{
    if (rate.isZero(0.0))
        return Vector3::Zero();
    const Matrix3 stretch = rotation.transpose() * matrix;
    const Matrix3 skew = rotation.transpose() * rate - rate.transpose() * rotation;
    const Matrix3 symmetric = 0.5 * (stretch + stretch.transpose());
    const Matrix3 system = symmetric.trace() * Matrix3::Identity() - symmetric;
    return rotation * Vector3(system.fullPivLu().solve(axial(skew)));
}

void require_whole_log(const Matrix3& rotation, const Vector3& log)
{
    const bool may_be_damped = log.norm() > half_turn;
    if (may_be_damped
        && (log_from_rotation(rotation).norm() < axisless
            || !tilt_beyond(rotation, log).isZero(0.0)))
        refuse_whole_turns();
}

Vector3 MotionRate::at(const RigidMotion& motion, const Vector3& point) const
{
    if (motion.rotation_log.isZero(0.0))
        return shift + spin.cross(point - motion.pivot);
    const Matrix3 rotation = motion.rotation();
    return shift + pivot + spin.cross(rotation * (point - motion.pivot)) - rotation * pivot;
}

MotionRate MotionRate::about(const RigidMotion& motion, const Vector3& centre) const
{
    return {at(motion, centre), log, Vector3::Zero(), spin};
}

// The covariance of best_rigid_motion_near() is start^T goal + s |start| |goal| I, and what is left
// of the rotation the polar factor of its transpose.
Vector3 best_motion_spin(const Points& from, const Points& to, const Points& rates,
                         const Turning& known)
{
    const Eigen::RowVector3d centre = from.colwise().mean();
    const Points start = (from.rowwise() - centre) * known.rotation.transpose();
    const Points goal = to.rowwise() - to.colwise().mean();
    const double length = goal.norm(), extent = start.norm() * length;
    if (extent == 0.0)
        return known.spin;
    const Points change = rates.rowwise() - rates.colwise().mean();
    const Points turning = start * cross_matrix(known.spin).transpose();
    const Matrix3 covariance =
        start.transpose() * goal + stiffness_of_known_rotation * extent * Matrix3::Identity();
    const double growth = start.norm() * goal.cwiseProduct(change).sum() / length;
    const Matrix3 rate = turning.transpose() * goal + start.transpose() * change
                         + stiffness_of_known_rotation * growth * Matrix3::Identity();
    const Matrix3 rest = nearest_rotation(covariance.transpose());
    return spin_of_polar(rest, covariance.transpose(), rate.transpose()) + rest * known.spin;
}

}  // namespace sheetmorph

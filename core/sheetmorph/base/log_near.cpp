// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/log_near.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/rotation.h"

#include <Eigen/Dense>
#include <cmath>

namespace sheetmorph
{

namespace
{

// How much of a turn across the axis a change of the logarithm makes: sin(|r|) / |r|. Where it is
// less than this (0 at whole turns) the change is damped.
constexpr double full_gain = 0.4;

// A tilt below this is what rounding leaves of none.
constexpr double rounding_tilt = 1e-12;

// Matrices flatter than this (or turned inside out) are left to the singular value decomposition.
constexpr double nearly_flat = 2e-4;

// 0 below `low`, 1 above `high`, without a kink between.
double smooth_step(double value, double low, double high)
{
    const double t = std::fmin(1.0, std::fmax(0.0, (value - low) / (high - low)));
    return t * t * (3.0 - 2.0 * t);
}

// d(rotation vector of the product) / d(log), for logs of half the angle on both sides:
// exp(log + d) = exp(J d) exp(log).
Matrix3 left_jacobian(const Vector3& log)
{
    const double angle = 2.0 * log.norm();
    if (angle < 1e-9)
        return Matrix3::Identity();
    const Vector3 axis = log * (2.0 / angle);
    const double sine = std::sin(angle) / angle, cosine = (1.0 - std::cos(angle)) / angle;
    return sine * Matrix3::Identity() + (1.0 - sine) * axis * axis.transpose()
           + cosine * cross_matrix(axis);
}

// One damped step from the reference: continuous in the rotation wherever its axis is.
Vector3 first_order_log(const Matrix3& rotation, const Vector3& reference)
{
    const double half = reference.norm();
    const Vector3 axis = reference / half;
    const double lack = std::fmax(0.0, full_gain - std::fabs(std::sin(half)) / half);
    const Matrix3 damping = lack * lack * (Matrix3::Identity() - axis * axis.transpose());
    const Vector3 rest = log_from_rotation(rotation * rotation_from_log(reference).transpose());
    const Matrix3 jacobian = left_jacobian(reference);
    const Matrix3 matrix = jacobian.transpose() * jacobian + damping;
    return reference + matrix.inverse() * (jacobian.transpose() * rest);
}

}  // namespace

Vector3 log_near(const Matrix3& rotation, const Vector3& reference)
{
    const Vector3 shortest = log_from_rotation(rotation);
    // A rotation near a whole turn has no axis to speak of, and its logarithm none nearby.
    const double turned = smooth_step(reference.norm(), 0.5 * pi, 0.6 * pi);
    const double axisless = smooth_step(-shortest.norm(), -0.35 * pi, -0.2 * pi);
    const double share = turned * axisless;
    if (share == 0.0)
        return nearest_branch(shortest, reference);
    const Vector3 estimate = first_order_log(rotation, reference);
    if (share == 1.0)
        return estimate;
    return share * estimate + (1.0 - share) * nearest_branch(shortest, reference);
}

Vector3 tilt_beyond(const Matrix3& rotation, const Vector3& log)
{
    const Vector3 tilt = log_from_rotation(rotation * rotation_from_log(log).transpose());
    return tilt.norm() < rounding_tilt ? Vector3(Vector3::Zero()) : tilt;
}

Matrix3 tilted_rotation(const Vector3& log, const Vector3& tilt)
{
    return tilt.isZero(0.0) ? rotation_from_log(log)
                            : Matrix3(rotation_from_log(tilt) * rotation_from_log(log));
}

// Newton: each round doubles the digits. What has not settled after the last is found by an SVD.
Matrix3 polar_rotation(const Matrix3& matrix)
{
    Matrix3 rotation = matrix;
    for (int step = 0; step < 20; ++step)
    {
        const double determinant = rotation.determinant();
        const double size = rotation.norm();
        if (!(determinant > nearly_flat * size * size * size))
            return nearest_rotation(matrix);
        const Matrix3 next = 0.5 * (rotation + rotation.inverse().transpose());
        const double change = (next - rotation).norm();
        rotation = next;
        if (change < 1e-9)
            return rotation;
    }
    return nearest_rotation(matrix);
}

}  // namespace sheetmorph

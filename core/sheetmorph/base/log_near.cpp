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

// A change of the log across its axis turns the rotation by sin(|r|) / |r| of it, and by nothing at
// a whole turn. Below this gain the change is damped. From geometry: the gain is 0.4 at an angle of
// 238 degrees, 122 degrees before a whole turn. log_near() begins to blend at 126 degrees.
constexpr double full_gain = 0.4;

// Radians. From rounding: a product of two rotations is exact to a few 1e-16. A tilt of 1e-12 moves
// a vertex by 1e-12 of the part's size, as much as mesh::exactness() allows.
constexpr double rounding_tilt = 1e-12;

// Determinant over cubed Frobenius norm (0.19 for a rotation); flatter or inverted matrices go to
// the singular value decomposition. Measured on random diag(1, 1, s): at the limit, s = 6e-4,
// Newton takes 16 of its 20 steps and is exact to 3e-14; at s = 1e-5 it needs 22.
constexpr double nearly_flat = 2e-4;

// A smooth step: 0 below `low`, 1 above `high`.
double smooth_step(double value, double low, double high)
{
    const double t = std::fmin(1.0, std::fmax(0.0, (value - low) / (high - low)));
    return t * t * (3.0 - 2.0 * t);
}

// d(rotation vector of the product) / d(log), where both logs are half angles: exp(log + d) = exp(J
// d) exp(log).
Matrix3 left_jacobian(const Vector3& log)
{
    const double angle = 2.0 * log.norm();
    // From the series: the next term, half the angle, is below the accuracy of 1e-9.
    if (angle < 1e-9)
        return Matrix3::Identity();
    const Vector3 axis = log * (2.0 / angle);
    const double sine = std::sin(angle) / angle, cosine = (1.0 - std::cos(angle)) / angle;
    return sine * Matrix3::Identity() + (1.0 - sine) * axis * axis.transpose()
           + cosine * cross_matrix(axis);
}

// One damped step from the reference. It is continuous in the rotation wherever the axis is.
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
    // A rotation near a whole turn has an undetermined axis, and no logarithm nearby. Half angles.
    // Chosen: the log is exact for a reference below half a turn (0.5 pi), or a rotation more than
    // 126 degrees (0.35 pi) from a whole turn. The blends are wide enough to be smooth.
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

// Newton: each step squares the error, so after a change of 1e-9 only rounding is left. If the
// steps have not converged, an SVD finds the rotation.
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

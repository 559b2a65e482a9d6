// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/rotation.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/limits.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

namespace sheetmorph
{

namespace
{
// Chosen: 160,000 turns. Rounding of such an angle, 1e-16 of it, is still only 1e-10 radians.
constexpr double most_radians = 1e6;
}  // namespace

Matrix3 cross_matrix(const Vector3& a)
{
    Matrix3 matrix;
    matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return matrix;
}

Vector3 rotation_log(const Vector3& axis, double radians)
{
    if (!(std::abs(radians) <= most_radians) || !are_numbers(axis))
        throw InvalidInput(
            "a rotation's axis and angle must be finite numbers, the angle at most "
            "1e6 radians");
    if (radians == 0.0)
        return Vector3::Zero();
    const double length = axis.stableNorm();
    if (length < 1e-300)
        throw InvalidInput("a rotation about an axis of length zero", "give the axis a direction");
    return axis * (0.5 * radians / length);
}

Matrix3 rotation_from_log(const Vector3& log)
{
    const double half = log.norm();
    if (half == 0.0)
        return Matrix3::Identity();
    return Eigen::AngleAxisd(2.0 * half, log / half).toRotationMatrix();
}

Vector3 log_from_rotation(const Matrix3& rotation)
{
    Eigen::Quaterniond q(rotation);
    if (q.w() < 0.0)
        q.coeffs() = -q.coeffs();
    const double sine = q.vec().norm();
    if (sine < 1e-300)
        return Vector3::Zero();
    return q.vec() * (std::atan2(sine, q.w()) / sine);
}

Vector3 nearest_branch(const Vector3& log, const Vector3& reference)
{
    const double half = log.norm();
    // From rounding: the axis of so small a rotation has four digits or fewer.
    if (half < 1e-12)
    {
        // The identity: every whole turn about the reference axis is the same rotation.
        const double turns = std::round(reference.norm() / pi);
        return turns == 0.0 ? log : Vector3(log + reference.normalized() * (turns * pi));
    }
    const Vector3 axis = log / half;
    const double turns = std::round((axis.dot(reference) - half) / pi);
    return axis * (half + turns * pi);
}

Matrix3 nearest_rotation(const Matrix3& matrix)
{
    const Eigen::JacobiSVD<Matrix3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vector3 signs = Vector3::Ones();
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0)
        signs(2) = -1.0;
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace sheetmorph

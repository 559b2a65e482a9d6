// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/steel/shell_element.h"

#include "sheetmorph/base/angles.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

namespace sheetmorph::surface
{

namespace
{

// Squared ratio of current to rest area below which a triangle resists a further loss of area, an
// area of 87 %. Chosen: steel never loses so much, and St. Venant and Kirchhoff's energy is still
// convex there (to 58 % of a length, see crushing()).
constexpr double first_crushed = 0.75;

// Relative to the elasticity of the sheet. Measured on one triangle under compression in one
// direction: the least second derivative of the energy is -0.55 without this term, 0.39 at 0.05,
// and from 0.125 on 0.69, the material's own at first_crushed. Chosen: twice that stiffness.
constexpr double crush_stiffness = 0.25;

// Ratios of areas: below the first, the energy is a parabola; the second bounds the stress at zero
// area. Chosen: a triangle with 3 % of its area has collapsed, and no converged answer has one. The
// logarithm there is steeper than any step can follow.
constexpr double last_crushed = 0.03;
constexpr double least_ratio = 1e-6;

int next(int corner)
{
    return (corner + 1) % 3;
}

Vector3 area_normal(const ShellElement::Corners& corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

// Angle about a side from the normal to the director, radians.
double angle_about(const Vector3& side, const Vector3& normal, const Vector3& director)
{
    return std::atan2(normal.cross(director).dot(side), normal.dot(director));
}

double wrapped(double angle)
{
    return angle - 2.0 * pi * std::round(angle / (2.0 * pi));
}

}  // namespace

ShellElement::ShellElement(const Place& rest, double poisson)
{
    const Vector3 double_area = area_normal(rest.corners);
    const Vector3 normal = double_area.normalized();
    area_ = 0.5 * double_area.norm();
    const Vector3 x = (rest.corners[1] - rest.corners[0]).normalized();
    const Vector3 y = normal.cross(x);
    elasticity_ << 1.0, poisson, 0.0, poisson, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - poisson);
    elasticity_ *= area_ / (1.0 - poisson * poisson);
    Matrix3 curvature;  // columns: k11, k22, 2 k12 per angle
    for (int k = 0; k < 3; ++k)
    {
        const Vector3 side = rest.corners[static_cast<std::size_t>(next(k))]
                             - rest.corners[static_cast<std::size_t>(k)];
        const Vector3 inwards = normal.cross(side.normalized());
        const double a = inwards.dot(x), b = inwards.dot(y);
        gradients_.row(next(next(k))) << a, b;
        gradients_.row(next(next(k))) *= side.norm() / (2.0 * area_);
        curvature.col(k) = side.norm() / area_ * Vector3(a * a, b * b, 2.0 * a * b);
        rest_angles_(k) =
            angle_about(side.normalized(), normal, rest.directors[static_cast<std::size_t>(k)]);
    }
    bending_ = curvature.transpose() * elasticity_ * curvature;
}

ShellElement::Strain ShellElement::strain(const Place& place) const
{
    Strain found;
    const Vector3 double_area = area_normal(place.corners);
    const double size = std::max(double_area.norm(), 1e-9 * area_);
    found.normal = double_area / size;
    found.f.setZero();
    for (int k = 0; k < 3; ++k)
    {
        const auto at = static_cast<std::size_t>(k);
        const Vector3 side = place.corners[static_cast<std::size_t>(next(k))] - place.corners[at];
        found.lengths(k) = std::max(side.norm(), 1e-12 * std::sqrt(area_));
        found.sides[at] = side / found.lengths(k);
        found.gradients[static_cast<std::size_t>(next(next(k)))] = found.normal.cross(side) / size;
        found.angles(k) = wrapped(angle_about(found.sides[at], found.normal, place.directors[at])
                                  - rest_angles_(k));
        found.f += place.corners[at] * gradients_.row(k);
    }
    found.membrane << 0.5 * (found.f.col(0).squaredNorm() - 1.0),
        0.5 * (found.f.col(1).squaredNorm() - 1.0), found.f.col(0).dot(found.f.col(1));
    return found;
}

// With t = det C relative to its limit: k (-ln t - (1 - t) - (1 - t)^2 / 2), convex in the strain.
// The energy of St. Venant and Kirchhoff alone is not convex below 0.58 of a length. It softens
// there, so that single triangles would collapse while the rest does not bend.
ShellElement::Crushing ShellElement::crushing(const Vector3& membrane)
{
    const double c11 = 1.0 + 2.0 * membrane(0), c22 = 1.0 + 2.0 * membrane(1), c12 = membrane(2);
    const double t = (c11 * c22 - c12 * c12) / first_crushed;
    Crushing found;
    if (t >= 1.0)
        return found;
    const double s = std::sqrt(std::max(t, least_ratio * least_ratio));
    const double lowest = last_crushed / std::sqrt(first_crushed);
    const double from = std::max(s, lowest), from_t = from * from;
    // With respect to s: value, slope and curvature where the logarithm ends, continued as a
    // parabola.
    const double by_t = -crush_stiffness * (1.0 - from_t) * (1.0 - from_t) / from_t;
    const double curvature = 2.0 * by_t + 4.0 * crush_stiffness * (1.0 / from_t - from_t);
    const double slope = 2.0 * from * by_t + curvature * (s - from);
    found.energy =
        crush_stiffness
            * (-std::log(from_t) - (1.0 - from_t) - 0.5 * (1.0 - from_t) * (1.0 - from_t))
        + (2.0 * from * by_t + 0.5 * curvature * (s - from)) * (s - from);
    const double first = slope / (2.0 * s) / first_crushed;
    const double second = (curvature - slope / s) / (4.0 * s * s) / (first_crushed * first_crushed);
    const Vector3 rate(2.0 * c22, 2.0 * c11, -2.0 * c12);
    found.stress = first * rate;
    found.tangent = second * rate * rate.transpose();
    found.tangent(0, 1) += 4.0 * first;
    found.tangent(1, 0) += 4.0 * first;
    found.tangent(2, 2) -= 2.0 * first;
    return found;
}

Vector3 ShellElement::membrane_stress(const Strain& strain) const
{
    return elasticity_ * strain.membrane + area_ * crushing(strain.membrane).stress;
}

Matrix3 ShellElement::membrane_tangent(const Strain& strain) const
{
    return elasticity_ + area_ * crushing(strain.membrane).tangent;
}

double ShellElement::energy(const Strain& strain, double bending) const
{
    return 0.5 * strain.membrane.dot(elasticity_ * strain.membrane)
           + area_ * crushing(strain.membrane).energy
           + 0.5 * bending * strain.angles.dot(bending_ * strain.angles);
}

ShellElement::Stress ShellElement::stress(const Strain& strain, double bending) const
{
    return {membrane_stress(strain), bending * (bending_ * strain.angles)};
}

ShellElement::Rows ShellElement::membrane_rows(const Strain& strain) const
{
    Rows rows = Rows::Zero();
    for (int i = 0; i < 3; ++i)
    {
        const double a = gradients_(i, 0), b = gradients_(i, 1);
        rows.block<1, 3>(0, 3 * i) = a * strain.f.col(0).transpose();
        rows.block<1, 3>(1, 3 * i) = b * strain.f.col(1).transpose();
        rows.block<1, 3>(2, 3 * i) = (a * strain.f.col(1) + b * strain.f.col(0)).transpose();
    }
    return rows;
}

// A rotation of the triangle about a side reduces its angle; a rotation of the director increases
// it.
ShellElement::Rows ShellElement::angle_rows(const Strain& strain)
{
    Rows rows = Rows::Zero();
    for (int k = 0; k < 3; ++k)
    {
        const Vector3 inwards = strain.normal.cross(strain.sides[static_cast<std::size_t>(k)]);
        for (int i = 0; i < 3; ++i)
            rows.block<1, 3>(k, 3 * i) = -strain.gradients[static_cast<std::size_t>(i)].dot(inwards)
                                         * strain.normal.transpose();
        rows(k, 9 + k) = 1.0;
    }
    return rows;
}

ShellElement::Stress ShellElement::predicted(const Strain& strain, double bending,
                                             const Vector& step) const
{
    return {membrane_stress(strain) + membrane_tangent(strain) * (membrane_rows(strain) * step),
            bending * (bending_ * (strain.angles + angle_rows(strain) * step))};
}

ShellElement::Vector ShellElement::gradient(const Strain& strain, double bending) const
{
    const Stress now = stress(strain, bending);
    return membrane_rows(strain).transpose() * now.membrane
           + angle_rows(strain).transpose() * now.moments;
}

// Second derivative of an angle in the frame transported with its side.
void ShellElement::add_turning(const Strain& strain, int side, double moment, Matrix& sum)
{
    const Vector3& t = strain.sides[static_cast<std::size_t>(side)];
    const Vector3& n = strain.normal;
    const Vector3 m = n.cross(t);
    const double length = strain.lengths(side);
    const auto gradient = [&strain](int i) -> const Vector3&
    { return strain.gradients[static_cast<std::size_t>(i)]; };
    const auto end = [side](int i) { return i == side ? -1.0 : (i == next(side) ? 1.0 : 0.0); };
    const Matrix3 normal_by_inwards = n * m.transpose() / (2.0 * length);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            const Matrix3 turn = gradient(i).dot(m) * gradient(j) * n.transpose()
                                 + gradient(j).dot(m) * n * gradient(i).transpose()
                                 + gradient(i).dot(t) * end(j) * normal_by_inwards
                                 + gradient(j).dot(t) * end(i) * normal_by_inwards.transpose();
            sum.block<3, 3>(3 * i, 3 * j) += moment * turn;
        }
}

ShellElement::Matrix ShellElement::stiffness(const Strain& strain, double bending,
                                             const Stress& of_second_order) const
{
    const Rows membrane = membrane_rows(strain);
    const Rows angles = angle_rows(strain);
    // For this size, lazy products are faster than Eigen's blocked products.
    const Rows stress_rows = membrane_tangent(strain).lazyProduct(membrane);
    const Rows moment_rows = (bending * bending_).lazyProduct(angles);
    Matrix sum = membrane.transpose().lazyProduct(stress_rows);
    sum += angles.transpose().lazyProduct(moment_rows);
    const Vector3& s = of_second_order.membrane;
    Eigen::Matrix2d pull;
    pull << s(0), s(2), s(2), s(1);
    const Matrix3 between = gradients_ * pull * gradients_.transpose();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sum.block<3, 3>(3 * i, 3 * j).diagonal().array() += between(i, j);
    for (int k = 0; k < 3; ++k)
        if (of_second_order.moments(k) != 0.0)
            add_turning(strain, k, of_second_order.moments(k), sum);
    return sum;
}

ShellElement::Stress ShellElement::tension(const Stress& stress)
{
    Eigen::Matrix2d pull;
    pull << stress.membrane(0), stress.membrane(2), stress.membrane(2), stress.membrane(1);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(pull);
    const Eigen::Matrix2d kept = eigen.eigenvectors()
                                 * eigen.eigenvalues().cwiseMax(0.0).asDiagonal()
                                 * eigen.eigenvectors().transpose();
    return {{kept(0, 0), kept(1, 1), kept(0, 1)}, Vector3::Zero()};
}

}  // namespace sheetmorph::surface

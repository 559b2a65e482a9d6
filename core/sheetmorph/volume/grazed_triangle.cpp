// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/grazed_triangle.h"

#include <Eigen/Dense>
#include <cmath>

namespace sheetmorph::volume
{

namespace
{

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Square = Eigen::Matrix<Real, 3, 3>;

// Elevation of the point above the triangle's plane. Weights divide by it. From rounding: long
// doubles (1e-19) keep ten digits at this elevation, and the limit in the plane, flat_weights(),
// differs from the weights there by about the elevation.
constexpr Real flat = 1e-9L;

// Columns of `corner`: the corners relative to the point.
Vector closest_on_edge(const Square& corner, int from, int to)
{
    const Vector edge = corner.col(to) - corner.col(from);
    const Real squared = edge.squaredNorm();
    const Real along = squared > 0 ? -corner.col(from).dot(edge) / squared : Real(0);
    const Real share = std::fmin(std::fmax(along, Real(0)), Real(1));
    Vector barycentric = Vector::Zero();
    barycentric(from) = 1 - share;
    barycentric(to) = share;
    return barycentric;
}

// Barycentric coordinates of the point of the triangle closest to the origin.
Vector closest_on_triangle(const Square& corner)
{
    const Vector normal = (corner.col(1) - corner.col(0)).cross(corner.col(2) - corner.col(0));
    const Real squared = normal.squaredNorm();
    if (squared > 0)
    {
        Vector barycentric;
        for (int k = 0; k < 3; ++k)
            barycentric(k) =
                normal.dot(corner.col((k + 1) % 3).cross(corner.col((k + 2) % 3))) / squared;
        if (barycentric.minCoeff() >= 0)
            return barycentric;
    }
    Vector best = closest_on_edge(corner, 0, 1);
    for (int k = 1; k < 3; ++k)
    {
        const Vector other = closest_on_edge(corner, k, (k + 1) % 3);
        if ((corner * other).squaredNorm() < (corner * best).squaredNorm())
            best = other;
    }
    return best;
}

// A triangle as seen from the point: unit directions to the corners, their distances, the cross
// products of the directions, and the integral m of the unit normal over the spherical triangle.
struct View
{
    explicit View(const Square& corner);

    Square unit, cross;
    Vector distance, integral;
};

View::View(const Square& corner)
{
    distance = corner.colwise().norm().transpose();
    for (int k = 0; k < 3; ++k)
        unit.col(k) = corner.col(k) / distance(k);
    integral.setZero();
    for (int k = 0; k < 3; ++k)
    {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const Vector edge = corner.col(j) - corner.col(i);
        cross.col(k) = unit.col(i).cross(edge) / distance(j);
        const Real sine = cross.col(k).norm();
        if (sine > 0)
            integral +=
                cross.col(k) * (std::atan2(sine, unit.col(i).dot(unit.col(j))) / (2 * sine));
    }
}

// In the plane, outside the triangle: m has no component along the normal, and the limit is the
// smallest weights y with sum y_k u_k = m. The vector form would divide rounding by rounding.
Vector flat_weights(const View& view)
{
    int widest = 0;
    view.cross.colwise().squaredNorm().maxCoeff(&widest);
    const Vector normal = view.cross.col(widest).normalized();
    const Vector first = view.unit.col((widest + 1) % 3);
    Eigen::Matrix<Real, 3, 2> plane;
    plane.col(0) = first;
    plane.col(1) = normal.cross(first);
    const Eigen::Matrix<Real, 2, 3> unit = plane.transpose() * view.unit;
    const Eigen::Matrix<Real, 2, 2> gram = unit * unit.transpose();
    if (!(gram.determinant() > 0))
        return Vector::Zero();
    const Vector share = unit.transpose() * (gram.inverse() * (plane.transpose() * view.integral));
    return share.cwiseQuotient(view.distance);
}

}  // namespace

GrazedTriangle grazed_triangle(const Matrix3& corners, const Vector3& point, double tolerance)
{
    const Square corner =
        (corners.cast<Real>().rowwise() - point.cast<Real>().transpose()).transpose();
    const Vector closest = closest_on_triangle(corner);
    const Real distance = (corner * closest).norm();
    GrazedTriangle result;
    result.on_surface = distance <= tolerance;
    if (result.on_surface)
    {
        result.weights = closest.cast<double>();
        return result;
    }
    const View view(corner);
    const Real volume = view.cross.col(0).dot(view.unit.col(0));
    const Real area = (corner.col(1) - corner.col(0)).cross(corner.col(2) - corner.col(0)).norm();
    const bool is_flat = std::fabs(volume) * view.distance.prod() <= flat * distance * area;
    const Vector weights =
        is_flat ? flat_weights(view)
                : Vector(
                    (view.cross.transpose() * view.integral / volume).cwiseQuotient(view.distance));
    result.weights = weights.cast<double>();
    return result;
}

}  // namespace sheetmorph::volume

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/circle.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/fitting/stadium.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace sheetmorph::fitting
{

namespace
{

// Width over length below which points count as collinear. From rounding: the direction of their
// plane is exact to 1e-16 over this ratio, 1e-8 radians at the limit.
constexpr double straightest = 1e-8;

// Least enclosed area over squared radius of a rim. From geometry: a square has 2.0, a hexagon 2.6.
// The border of a narrow curved strip has less: it follows an arc of a large circle and returns
// close to it.
constexpr double least_area = 2.0;

// Frame of the best-fitting plane; columns: two directions in the plane, and its normal.
Matrix3 best_plane(const Points& offsets, double noise)
{
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(offsets, Eigen::ComputeThinV);
    const Eigen::VectorXd spread = svd.singularValues();
    if (spread(1) <= std::max(straightest * spread(0), noise))
        throw InvalidInput(
            "the " + std::to_string(offsets.rows()) + " points of a circle lie on one line",
            "give points around its rim");
    Matrix3 frame = svd.matrixV();
    frame.col(2) = frame.col(0).cross(frame.col(1));
    return frame;
}

// The algebraic fit |p|^2 = 2 c.p + s (Kasa): exact on a circle, and the start of the geometric
// fit.
Stadium algebraic_circle(const PlanePoints& points)
{
    Eigen::MatrixXd terms(points.rows(), 3);
    terms << 2.0 * points, Eigen::VectorXd::Ones(points.rows());
    const Eigen::Vector3d fit = terms.colPivHouseholderQr().solve(points.rowwise().squaredNorm());
    Stadium circle;
    circle.centre = fit.head<2>();
    circle.radius = std::sqrt(std::max(0.0, fit(2) + fit.head<2>().squaredNorm()));
    return circle;
}

// Orient the axis so that the points run counter-clockwise around it.
Vector3 oriented_axis(const Vector3& normal, const Points& offsets)
{
    const double sense = normal.dot(doubled_area(offsets));
    // Chosen: points of an arc in any order enclose about nothing; their rounding is 1e-16.
    if (std::abs(sense) > 1e-6 * offsets.squaredNorm())
        return sense > 0.0 ? normal : Vector3(-normal);
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal(largest) > 0.0 ? normal : Vector3(-normal);
}

}  // namespace

Vector3 doubled_area(const Points& loop)
{
    Vector3 area = Vector3::Zero();
    const Eigen::Index count = loop.rows();
    for (Eigen::Index i = 1; i + 1 < count; ++i)
        area += Vector3(loop.row(i) - loop.row(0)).cross(Vector3(loop.row(i + 1) - loop.row(0)));
    return area;
}

bool encloses_area(const Points& loop)
{
    return 0.5 * doubled_area(loop).norm()
           > straightest * (loop.rowwise() - loop.row(0)).squaredNorm();
}

CircleFit fit_circle(const Points& points)
{
    if (points.rows() < 3)
        throw InvalidInput("a circle needs at least 3 points, " + std::to_string(points.rows())
                           + " are given");
    if (!points.allFinite())
        throw InvalidInput("the points of a circle have coordinates that are not finite numbers");
    const Eigen::RowVector3d centroid =
        points.row(0) + (points.rowwise() - points.row(0)).colwise().mean();
    const Points offsets = points.rowwise() - centroid;
    const double rounding =
        8.0 * std::numeric_limits<double>::epsilon() * points.cwiseAbs().maxCoeff();
    const Matrix3 frame = best_plane(offsets, rounding);
    const double scale = std::sqrt(offsets.squaredNorm() / static_cast<double>(offsets.rows()));
    const PlanePoints flat = offsets * frame.leftCols<2>() / scale;
    Stadium circle = algebraic_circle(flat);
    CircleFit fit;
    fit.convergence = fit_stadium(flat, {"the circle's position and radius"}, circle);
    fit.convergence.miss *= circle.radius * scale;
    fit.centre = centroid.transpose() + frame.leftCols<2>() * circle.centre * scale;
    fit.axis = oriented_axis(frame.col(2), offsets);
    fit.radius = circle.radius * scale;
    const Eigen::ArrayXd in_plane = circle.misses(flat).array() * scale;
    const Eigen::ArrayXd off_plane = (offsets * frame.col(2)).array();
    fit.residual = (in_plane.square() + off_plane.square()).sqrt().maxCoeff();
    return fit;
}

std::optional<CircleFit> round_rim(const Points& rim, double tolerance)
{
    if (rim.rows() < fewest_rim_points || !encloses_area(rim))
        return std::nullopt;
    const CircleFit circle = fit_circle(rim);
    if (circle.convergence.is_converged && circle.residual < tolerance * circle.radius
        && 0.5 * doubled_area(rim).norm() > least_area * circle.radius * circle.radius)
        return circle;
    return std::nullopt;
}

}  // namespace sheetmorph::fitting

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/oriented_box.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

namespace sheetmorph::volume
{

namespace
{

// Relative difference of two principal values; below it the axes in their plane are undetermined.
// From rounding: values are exact to 1e-16 and axes to 1e-16 over the difference, so ten digits of
// the axes are left at this limit.
constexpr double equal_values = 1e-6;

// Relative to the largest principal value. Values are squares of lengths: the points are as thin as
// 1e-5 of their length. Chosen below every sheet (1e-4) and far above rounding.
constexpr double no_extent = 1e-10;

void check_points(const Points& points)
{
    if (points.rows() == 0)
        throw InvalidInput("a box around no points", "give the region at least one vertex");
    if (!points.allFinite())
        throw InvalidInput("a box around points with coordinates that are not finite numbers");
}

bool agree(double larger, double smaller, double largest)
{
    return larger <= no_extent * largest || larger - smaller <= equal_values * larger;
}

// A direction perpendicular to `normal`: the first axis of the fallback that is not steep to the
// plane, projected.
Vector3 across(const Vector3& normal, const Matrix3& fallback)
{
    for (int k = 0; k < 3; ++k)
    {
        const Vector3 flat = fallback.col(k) - normal * normal.dot(fallback.col(k));
        if (flat.norm() > 0.5)
            return flat.normalized();
    }
    return normal.unitOrthogonal();
}

// Signs do not change the box. This choice makes the frame right-handed and the same in every run.
Matrix3 with_signs(Matrix3 axes, const Matrix3& fallback)
{
    for (int k = 0; k < 3; ++k)
    {
        int nearest = 0;
        (fallback.transpose() * axes.col(k)).cwiseAbs().maxCoeff(&nearest);
        if (fallback.col(nearest).dot(axes.col(k)) < 0.0)
            axes.col(k) *= -1.0;
    }
    if (axes.determinant() < 0.0)
        axes.col(2) *= -1.0;
    return axes;
}

}  // namespace

Matrix3 principal_axes(const Points& points, const Eigen::VectorXd& weights,
                       const Matrix3& fallback)
{
    check_points(points);
    Eigen::VectorXd share = Eigen::VectorXd::Ones(points.rows());
    if (weights.size() == points.rows() && weights.sum() > 0.0)
        share = weights;
    share /= share.sum();
    const Eigen::RowVector3d centre = share.transpose() * points;
    const Points arms = points.rowwise() - centre;
    const Matrix3 moments = arms.transpose() * share.asDiagonal() * arms;
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(moments);
    const Vector3 value = solver.eigenvalues().reverse();
    Matrix3 axes = solver.eigenvectors().rowwise().reverse();
    const double rounding = 1e-30 * (arms.rowwise() + centre).cwiseAbs2().maxCoeff();
    const bool first_open = value(0) <= rounding || agree(value(0), value(1), value(0));
    const bool last_open = value(0) <= rounding || agree(value(1), value(2), value(0));
    if (first_open && last_open)
        return with_signs(fallback, fallback);
    if (first_open)
    {
        axes.col(0) = across(axes.col(2), fallback);
        axes.col(1) = axes.col(2).cross(axes.col(0));
    }
    if (last_open)
    {
        axes.col(1) = across(axes.col(0), fallback);
        axes.col(2) = axes.col(0).cross(axes.col(1));
    }
    return with_signs(axes, fallback);
}

OrientedBox oriented_box(const Points& points, const Matrix3& axes, const BoxOptions& options)
{
    check_points(points);
    if (!(options.margin >= 0.0 && options.minimum_thickness >= 0.0
          && options.single_point_size > 0.0))
        throw InvalidInput(
            "the margin and the minimum thickness of a control mesh must not be "
            "negative, and the size around a single point must be positive");
    const Eigen::RowVector3d origin = points.row(0);
    const Points local = (points.rowwise() - origin) * axes;
    const Vector3 low = local.colwise().minCoeff(), high = local.colwise().maxCoeff();
    const Vector3 half = 0.5 * (high - low);
    OrientedBox box;
    box.axes = axes;
    box.centre = origin.transpose() + axes * (0.5 * (low + high));
    const double largest = half.maxCoeff();
    if (largest > 1e-15 * points.cwiseAbs().maxCoeff())
        box.half_extents =
            half.cwiseMax(options.minimum_thickness * largest).array() + options.margin * largest;
    else
        box.half_extents.setConstant(options.single_point_size);
    // Without margin and thickness a flat set would leave the control mesh no volume. Chosen: as
    // thin as a sheet, a thousandth.
    box.half_extents = box.half_extents.cwiseMax(1e-3 * box.half_extents.maxCoeff());
    box.widened_by = box.half_extents - half;
    return box;
}

}  // namespace sheetmorph::volume

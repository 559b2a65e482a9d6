// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/forms/cylinder_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

namespace sheetmorph
{

namespace
{

// Of the radius.
constexpr double tolerance = 0.02;

// Most rounds of the fit, and the step over the radius after which nothing counts.
constexpr int most_rounds = 30;
constexpr double at_rest = 1e-15;
constexpr double settled = 1e-7;

// Share of the normals' spread along the axis, at most, and along the second direction, at least.
constexpr double most_axial = 0.01;
constexpr double least_bent = 0.02;

// Normals weighted by area: the directions they spread along, the axis (least) first.
Eigen::SelfAdjointEigenSolver<Matrix3> spread_of_normals(const TriangleMesh& mesh)
{
    Matrix3 spread = Matrix3::Zero();
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const Vector3 a = mesh.points().row(mesh.triangles()(t, 0)).transpose();
        const Vector3 b = mesh.points().row(mesh.triangles()(t, 1)).transpose();
        const Vector3 c = mesh.points().row(mesh.triangles()(t, 2)).transpose();
        const Vector3 normal = (b - a).cross(c - a);
        if (normal.norm() > 0.0)
            spread += normal * normal.transpose() / normal.norm();
    }
    return Eigen::SelfAdjointEigenSolver<Matrix3>(spread);
}

void set_axis(RimProfile& cylinder, const Vector3& axis)
{
    cylinder.frame.col(2) = axis.normalized();
    cylinder.frame.col(0) = cylinder.frame.col(2).unitOrthogonal();
    cylinder.frame.col(1) = cylinder.frame.col(2).cross(cylinder.frame.col(0));
}

// The circle |q|^2 = 2 c.q + s through the points along the axis (Kasa), for a start.
RimProfile first_cylinder(const Points& points, const Vector3& axis)
{
    RimProfile cylinder;
    set_axis(cylinder, axis);
    cylinder.centre = points.colwise().mean().transpose();
    const Eigen::Matrix<double, Eigen::Dynamic, 2> flat =
        (points.rowwise() - cylinder.centre.transpose()) * cylinder.frame.leftCols<2>();
    const double unit = std::max(flat.cwiseAbs().maxCoeff(), 1e-300);
    Eigen::MatrixXd terms(points.rows(), 3);
    terms << 2.0 * flat / unit, Eigen::VectorXd::Ones(points.rows());
    const Vector3 fit = terms.colPivHouseholderQr().solve((flat / unit).rowwise().squaredNorm());
    cylinder.centre += cylinder.frame.leftCols<2>() * fit.head<2>() * unit;
    cylinder.radius = std::sqrt(std::max(0.0, fit(2) + fit.head<2>().squaredNorm())) * unit;
    return cylinder;
}

// One Gauss-Newton step in the place and tilt of the axis and the radius; its length over that.
double improve(const Points& points, RimProfile& cylinder)
{
    const Vector3 u = cylinder.frame.col(0);
    const Vector3 v = cylinder.frame.col(1);
    Eigen::MatrixXd rows(points.rows(), 5);
    Eigen::VectorXd miss(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
        const Vector3 point = points.row(i).transpose();
        const Vector3 out = cylinder.outward(point);
        const double height = cylinder.height(point) / cylinder.radius;
        miss(i) = cylinder.distance(point) / cylinder.radius;
        rows.row(i) << -out.dot(u), -out.dot(v), -height * out.dot(u), -height * out.dot(v), -1.0;
    }
    const Eigen::VectorXd step = -rows.colPivHouseholderQr().solve(miss);
    cylinder.centre += cylinder.radius * (step(0) * u + step(1) * v);
    cylinder.radius *= 1.0 + step(4);
    set_axis(cylinder, cylinder.frame.col(2) + step(2) * u + step(3) * v);
    return step.norm();
}

}  // namespace

std::optional<RimProfile> fit_cylinder(const TriangleMesh& mesh)
{
    if (mesh.triangle_count() < 2 || mesh.vertex_count() < 6)
        return std::nullopt;
    const auto spread = spread_of_normals(mesh);
    const Vector3 shares = spread.eigenvalues() / spread.eigenvalues().sum();
    if (!(shares(0) < most_axial && shares(1) > least_bent))
        return std::nullopt;
    RimProfile cylinder = first_cylinder(mesh.points(), spread.eigenvectors().col(0));
    double moved = 1.0;
    for (int round = 0; round < most_rounds && moved > at_rest && cylinder.radius > 0.0; ++round)
        moved = improve(mesh.points(), cylinder);
    if (!(cylinder.radius > 0.0) || !cylinder.centre.allFinite() || !(moved <= settled))
        return std::nullopt;
    for (Eigen::Index i = 0; i < mesh.points().rows(); ++i)
        if (std::abs(cylinder.distance(mesh.points().row(i).transpose()))
            > tolerance * cylinder.radius)
            return std::nullopt;
    return cylinder;
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/forms/cylinder_fit.h"

#include "sheetmorph/numerics/newton_minimum.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <limits>

namespace sheetmorph
{

namespace
{

// Of the radius.
constexpr double tolerance = 0.02;

// Most rounds of the fit, and the step over the radius that counts as none.
constexpr int most_rounds = 30;
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

//! The place and tilt of the axis and the radius, by Gauss-Newton steps for the distances.
class CylinderProblem : public NewtonProblem
{
public:
    CylinderProblem(const Points& points, const RimProfile& start)
        : points_(points), cylinder_(start), before_(start)
    {
    }

    const RimProfile& cylinder() const { return cylinder_; }

    double value() override
    {
        if (!(cylinder_.radius > 0.0))
            return std::numeric_limits<double>::infinity();
        double sum = 0.0;
        for (Eigen::Index i = 0; i < points_.rows(); ++i)
            sum += std::pow(cylinder_.distance(points_.row(i).transpose()), 2);
        return sum;
    }

    std::optional<NewtonStep> step(int) override
    {
        const Vector3 u = cylinder_.frame.col(0), v = cylinder_.frame.col(1);
        Eigen::MatrixXd rows(points_.rows(), 5);
        Eigen::VectorXd miss(points_.rows());
        for (Eigen::Index i = 0; i < points_.rows(); ++i)
        {
            const Vector3 point = points_.row(i).transpose();
            const Vector3 out = cylinder_.outward(point);
            const double height = cylinder_.height(point) / cylinder_.radius;
            miss(i) = cylinder_.distance(point) / cylinder_.radius;
            rows.row(i) << -out.dot(u), -out.dot(v), -height * out.dot(u), -height * out.dot(v),
                -1.0;
        }
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(rows);
        if (factor.rank() < 5)
            return std::nullopt;
        NewtonStep found{-factor.solve(miss)};
        found.length = found.change.norm();
        found.slope = 2.0 * cylinder_.radius * cylinder_.radius * miss.dot(rows * found.change);
        return found;
    }

    void remember() override { before_ = cylinder_; }
    void restore() override { cylinder_ = before_; }
    void move(const NewtonStep& step, double share) override
    {
        const Eigen::VectorXd change = share * step.change;
        const Vector3 u = before_.frame.col(0), v = before_.frame.col(1);
        cylinder_ = before_;
        cylinder_.centre += before_.radius * (change(0) * u + change(1) * v);
        cylinder_.radius *= 1.0 + change(4);
        set_axis(cylinder_, before_.frame.col(2) + change(2) * u + change(3) * v);
    }

private:
    const Points& points_;
    RimProfile cylinder_, before_;
};

}  // namespace

std::optional<RimProfile> fit_cylinder(const TriangleMesh& mesh)
{
    if (mesh.triangle_count() < 2 || mesh.vertex_count() < 6)
        return std::nullopt;
    const auto spread = spread_of_normals(mesh);
    const Vector3 shares = spread.eigenvalues() / spread.eigenvalues().sum();
    if (!(shares(0) < most_axial && shares(1) > least_bent))
        return std::nullopt;
    CylinderProblem problem(mesh.points(),
                            first_cylinder(mesh.points(), spread.eigenvectors().col(0)));
    NewtonLimits limits{"the cylinder"};
    limits.most_rounds = most_rounds;
    limits.settled = settled;
    if (!newton_minimum(problem, limits).is_converged)
        return std::nullopt;
    const RimProfile cylinder = problem.cylinder();
    for (Eigen::Index i = 0; i < mesh.points().rows(); ++i)
        if (std::abs(cylinder.distance(mesh.points().row(i).transpose()))
            > tolerance * cylinder.radius)
            return std::nullopt;
    return cylinder;
}

}  // namespace sheetmorph

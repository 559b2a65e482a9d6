// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/regions/circle.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/topology/boundary.h"
#include "sheetmorph/numerics/newton_minimum.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <string>

namespace sheetmorph
{

namespace
{

// Width over length below which points count as lying on one line.
constexpr double straightest = 1e-8;

constexpr int fewest_rim_vertices = 6;

// Rounds of the fit, and the steps over the radius that count as small and as none. Rims take 3 to
// 10 rounds.
constexpr int most_rounds = 100;
constexpr double settled = 1e-9;
constexpr double finest = 1e-16;

// Enclosed area over squared radius that tells a rim (2.6 for a hexagon) from the border of a
// narrow curved strip, which lies close to a large circle without going around it.
constexpr double least_area = 2.0;

using Plane = Eigen::Matrix<double, Eigen::Dynamic, 2>;

struct Circle2
{
    Eigen::Vector2d centre;
    double radius;
};

// The frame of the best plane: columns along it, along it, normal to it.
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

// The algebraic fit |p|^2 = 2 c.p + s (Kasa): exact on a circle, the start of the geometric one.
Circle2 algebraic_circle(const Plane& points)
{
    Eigen::MatrixXd terms(points.rows(), 3);
    terms << 2.0 * points, Eigen::VectorXd::Ones(points.rows());
    const Eigen::Vector3d fit = terms.colPivHouseholderQr().solve(points.rowwise().squaredNorm());
    return {fit.head<2>(), std::sqrt(std::max(0.0, fit(2) + fit.head<2>().squaredNorm()))};
}

Eigen::VectorXd misses(const Plane& points, const Circle2& circle)
{
    return (points.rowwise() - circle.centre.transpose()).rowwise().norm().array() - circle.radius;
}

//! The circle's place and radius, by Gauss-Newton steps for the distances to it.
class CircleProblem : public NewtonProblem
{
public:
    CircleProblem(const Plane& points, const Circle2& start)
        : points_(points), circle_(start), before_(start)
    {
    }

    const Circle2& circle() const { return circle_; }

    double value() override { return misses(points_, circle_).squaredNorm(); }

    std::optional<NewtonStep> step(int) override
    {
        const Plane out = points_.rowwise() - circle_.centre.transpose();
        Eigen::MatrixXd jacobian(points_.rows(), 3);
        jacobian << -out.rowwise().normalized(), -Eigen::VectorXd::Ones(points_.rows());
        const Eigen::VectorXd miss = misses(points_, circle_);
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(jacobian);
        if (factor.rank() < 3)
            return std::nullopt;
        NewtonStep found{-factor.solve(miss)};
        found.length = found.change.norm() / circle_.radius;
        found.slope = 2.0 * miss.dot(jacobian * found.change);
        return found;
    }

    void remember() override { before_ = circle_; }
    void restore() override { circle_ = before_; }
    void move(const NewtonStep& step, double share) override
    {
        circle_ = {before_.centre + share * step.change.head<2>(),
                   before_.radius + share * step.change(2)};
    }

private:
    const Plane& points_;
    Circle2 circle_, before_;
};

// Twice the area the points go around, as a vector: its side of the plane is their sense.
Vector3 sense_of_rotation(const Points& offsets)
{
    Vector3 sense = Vector3::Zero();
    for (Eigen::Index i = 0; i < offsets.rows(); ++i)
        sense += Vector3(offsets.row(i)).cross(Vector3(offsets.row((i + 1) % offsets.rows())));
    return sense;
}

double enclosed_area(const Points& rim)
{
    return 0.5 * sense_of_rotation(rim.rowwise() - rim.row(0)).norm();
}

Vector3 oriented_axis(const Vector3& normal, const Points& offsets)
{
    const double sense = normal.dot(sense_of_rotation(offsets));
    if (std::abs(sense) > 1e-6 * offsets.squaredNorm())
        return sense > 0.0 ? normal : Vector3(-normal);
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal(largest) > 0.0 ? normal : Vector3(-normal);
}

}  // namespace

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
    const Matrix3 frame = best_plane(offsets, exactness(points, 0.0));
    const double scale = std::sqrt(offsets.squaredNorm() / static_cast<double>(offsets.rows()));
    const Plane flat = offsets * frame.leftCols<2>() / scale;
    CircleProblem problem(flat, algebraic_circle(flat));
    NewtonLimits limits{"the circle's place and radius"};
    limits.most_rounds = most_rounds;
    limits.settled = settled;
    limits.finest = finest;
    CircleFit fit;
    fit.convergence = newton_minimum(problem, limits);
    const Circle2& circle = problem.circle();
    fit.convergence.miss *= circle.radius * scale;
    fit.centre = centroid.transpose() + frame.leftCols<2>() * circle.centre * scale;
    fit.axis = oriented_axis(frame.col(2), offsets);
    fit.radius = circle.radius * scale;
    const Eigen::ArrayXd in_plane = misses(flat, circle).array() * scale;
    const Eigen::ArrayXd off_plane = (offsets * frame.col(2)).array();
    fit.residual = (in_plane.square() + off_plane.square()).sqrt().maxCoeff();
    return fit;
}

std::optional<CircleFit> round_rim(const Points& rim, double tolerance)
{
    if (rim.rows() < fewest_rim_vertices)
        return std::nullopt;
    const double area = enclosed_area(rim);
    if (area <= straightest * (rim.rowwise() - rim.row(0)).squaredNorm())
        return std::nullopt;  // a slit, which no circle fits
    const CircleFit circle = fit_circle(rim);
    if (circle.convergence.is_converged && circle.residual < tolerance * circle.radius
        && area > least_area * circle.radius * circle.radius)
        return circle;
    return std::nullopt;
}

std::vector<RoundHole> round_holes(const TriangleMesh& mesh, double tolerance)
{
    if (!(tolerance > 0.0))
        throw InvalidInput("the tolerance of round holes must be greater than 0");
    std::vector<RoundHole> holes;
    for (const VertexIds& loop : boundary_loops(mesh))
        if (const auto circle = round_rim(mesh.points()(loop, Eigen::indexing::all), tolerance))
            holes.push_back({loop, *circle});
    return holes;
}

}  // namespace sheetmorph

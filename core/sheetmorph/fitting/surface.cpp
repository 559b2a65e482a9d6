// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/surface.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph::fitting
{

namespace
{

struct Spread
{
    Vector3 mean = Vector3::Zero();  // of normals, weighted by area
    Eigen::SelfAdjointEigenSolver<Matrix3> about_zero;
    Eigen::SelfAdjointEigenSolver<Matrix3> about_mean;
};

Spread spread_of(const FacetSample& facets)
{
    Spread spread;
    Matrix3 square = Matrix3::Zero();
    double area = 0.0;
    for (Eigen::Index t = 0; t < facets.areas.size(); ++t)
    {
        const Vector3 normal = facets.normals.row(t).transpose();
        spread.mean += facets.areas(t) * normal;
        square += facets.areas(t) * normal * normal.transpose();
        area += facets.areas(t);
    }
    spread.mean /= std::max(area, 1e-300);
    square /= std::max(area, 1e-300);
    spread.about_zero.computeDirect(square);
    spread.about_mean.computeDirect(square - spread.mean * spread.mean.transpose());
    return spread;
}

Vector3 middle_of(const FacetSample& facets)
{
    Vector3 middle = Vector3::Zero();
    for (Eigen::Index t = 0; t < facets.areas.size(); ++t)
        middle += facets.centroids.row(t).transpose() / static_cast<double>(facets.areas.size());
    return middle;
}

// The sphere |p|^2 = 2 c.p + s by least squares (Kasa). With a non-zero `axis`, only directions
// across it count, which gives a cylinder.
std::optional<Surface> ball(const FacetSample& facets, const Vector3& axis)
{
    const Vector3 middle = middle_of(facets);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (Eigen::Index i = 0; i < facets.corners.rows(); ++i)
    {
        const Vector3 off = facets.corners.row(i).transpose() - middle;
        const Vector3 flat = off - axis.dot(off) * axis;
        Eigen::Vector4d row;
        row << 2.0 * flat, 1.0;
        normal += row * row.transpose();
        right += row * flat.squaredNorm();
    }
    normal.topLeftCorner<3, 3>() += normal(0, 0) * axis * axis.transpose();
    const Eigen::LDLT<Eigen::Matrix4d> factor(normal);
    const Eigen::Vector4d solved = factor.solve(right);
    const Vector3 center = solved.head<3>() - axis.dot(solved.head<3>()) * axis;
    const double square = solved(3) + center.squaredNorm();
    if (factor.info() != Eigen::Success || !(square > 0.0) || !std::isfinite(square))
        return std::nullopt;
    Surface surface;
    surface.point = middle + center;
    surface.radius = std::sqrt(square);
    return surface;
}

std::optional<Surface> cylinder(const FacetSample& facets, const SpreadLimits& limits)
{
    const Spread spread = spread_of(facets);
    const Vector3 values = spread.about_zero.eigenvalues();
    if (values(0) > limits.flattest || values(1) < limits.turning)
        return std::nullopt;
    const Vector3 axis = spread.about_zero.eigenvectors().col(0);
    std::optional<Surface> surface = ball(facets, axis);
    if (surface)
    {
        surface->kind = Surface::Kind::cylinder;
        surface->axis = axis;
    }
    return surface;
}

std::optional<Surface> sphere(const FacetSample& facets, const SpreadLimits& limits)
{
    const Vector3 values = spread_of(facets).about_mean.eigenvalues();
    // Chosen: the patch of a sphere bends in both directions, 2.6 times as far in one at most.
    if (values(1) < limits.turning || values(1) < 0.15 * values(2))
        return std::nullopt;
    std::optional<Surface> surface = ball(facets, Vector3::Zero());
    if (surface)
        surface->kind = Surface::Kind::sphere;
    return surface;
}

// On a cone, all normals make the same angle with the axis, and every tangent plane contains the
// apex.
std::optional<Surface> cone(const FacetSample& facets, const SpreadLimits& limits)
{
    const Spread spread = spread_of(facets);
    const Vector3 values = spread.about_mean.eigenvalues();
    Surface surface;
    surface.kind = Surface::Kind::cone;
    surface.axis = spread.about_mean.eigenvectors().col(0);
    const double sine = std::abs(spread.mean.dot(surface.axis));
    // Chosen: half angles of 3.4 to 78.5 degrees; others are cylinders or planes.
    if (values(0) > 0.2 * limits.flattest || values(1) < limits.turning || sine < 0.06
        || sine > 0.98)
        return std::nullopt;
    Matrix3 normal = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
    const Vector3 middle = middle_of(facets);
    for (Eigen::Index t = 0; t < facets.areas.size(); ++t)
    {
        const Vector3 own = facets.normals.row(t).transpose();
        normal += facets.areas(t) * own * own.transpose();
        right += facets.areas(t) * own * own.dot(facets.centroids.row(t).transpose() - middle);
    }
    surface.point = middle + normal.ldlt().solve(right);
    surface.angle = std::asin(sine);
    if (surface.axis.dot(middle - surface.point) < 0.0)
        surface.axis = -surface.axis;
    return surface.point.allFinite() ? std::optional<Surface>(surface) : std::nullopt;
}

std::optional<Surface> plane(const FacetSample& facets)
{
    const Spread spread = spread_of(facets);
    Surface surface;
    surface.axis = spread.about_zero.eigenvectors().col(2);
    if (surface.axis.dot(spread.mean) < 0.0)
        surface.axis = -surface.axis;
    double area = 0.0;
    for (Eigen::Index t = 0; t < facets.areas.size(); ++t)
    {
        surface.point += facets.areas(t) * facets.centroids.row(t).transpose();
        area += facets.areas(t);
    }
    surface.point /= std::max(area, 1e-300);
    return surface;
}

using Row = Eigen::Matrix<double, 7, 1>;
using Normal = Eigen::Matrix<double, 7, 7>;

// Derivatives of a point's offset by the point of the surface (3), the tilt of its axis in two
// directions, its radius and its angle.
Row slope_at(const Surface& surface, const Vector3& place, const Vector3& u, const Vector3& v)
{
    const Vector3 off = place - surface.point;
    const double along = off.dot(surface.axis);
    const Vector3 flat = off - along * surface.axis;
    const double away = flat.norm();
    const Vector3 out = flat / std::max(away, 1e-300);
    Row slope = Row::Zero();
    slope.head<3>() = -surface.normal(place);
    if (surface.kind == Surface::Kind::cone)
    {
        const double tilt = -along * std::cos(surface.angle) - away * std::sin(surface.angle);
        slope(3) = tilt * out.dot(u);
        slope(4) = tilt * out.dot(v);
        slope(6) = -away * std::sin(surface.angle) - along * std::cos(surface.angle);
        return slope;
    }
    slope(5) = -1.0;
    if (surface.kind == Surface::Kind::cylinder)
    {
        slope(3) = -along * out.dot(u);
        slope(4) = -along * out.dot(v);
    }
    return slope;
}

Surface stepped(Surface surface, const Row& step, const Vector3& u, const Vector3& v)
{
    surface.point += step.head<3>();
    surface.axis = (surface.axis + step(3) * u + step(4) * v).normalized();
    surface.radius += step(5);
    surface.angle += step(6);
    return surface;
}

double squares_of(const Points& points, const Surface& surface)
{
    double sum = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        sum += std::pow(surface.offset(points.row(i).transpose()), 2);
    return sum;
}

}  // namespace

double Surface::offset(const Vector3& place) const
{
    const Vector3 off = place - point;
    const double along = off.dot(axis);
    const double away = (off - along * axis).norm();
    switch (kind)
    {
        case Kind::cylinder:
            return away - radius;
        case Kind::sphere:
            return off.norm() - radius;
        case Kind::cone:
            return away * std::cos(angle) - along * std::sin(angle);
        default:
            return along;
    }
}

Vector3 Surface::normal(const Vector3& place) const
{
    const Vector3 off = place - point;
    const Vector3 out = (off - off.dot(axis) * axis).normalized();
    switch (kind)
    {
        case Kind::cylinder:
            return out;
        case Kind::sphere:
            return off.normalized();
        case Kind::cone:
            return std::cos(angle) * out - std::sin(angle) * axis;
        default:
            return axis;
    }
}

double Surface::radius_at(const Vector3& place) const
{
    const Vector3 off = place - point;
    return kind == Kind::cone ? (off - off.dot(axis) * axis).norm() : radius;
}

std::optional<Surface> fit_surface(const FacetSample& facets, Surface::Kind kind,
                                   const SpreadLimits& limits)
{
    if (kind == Surface::Kind::cylinder)
        return cylinder(facets, limits);
    if (kind == Surface::Kind::sphere)
        return sphere(facets, limits);
    return kind == Surface::Kind::cone ? cone(facets, limits) : plane(facets);
}

Surface refined(const Points& points, const Surface& start)
{
    // Every accepted step reduces the sum, so an early end is safe; callers check the residual.
    constexpr int most_steps = 12;  // chosen, not measured
    Surface best = start;
    double least = squares_of(points, best);
    // Levenberg-Marquardt (Marquardt 1963), relative to the diagonal. Chosen: near Gauss-Newton at
    // first, a hundred times more after a failure, a tenth after a success.
    double damping = 1e-6;
    for (int step = 0; step < most_steps; ++step)
    {
        const Vector3 u = best.axis.unitOrthogonal();
        const Vector3 v = best.axis.cross(u);
        Normal normal = Normal::Zero();
        Row right = Row::Zero();
        for (Eigen::Index i = 0; i < points.rows(); ++i)
        {
            const Vector3 point = points.row(i).transpose();
            const Row slope = slope_at(best, point, u, v);
            normal.selfadjointView<Eigen::Lower>().rankUpdate(slope);
            right -= best.offset(point) * slope;
        }
        normal = normal.selfadjointView<Eigen::Lower>();
        normal.diagonal() += damping * (normal.diagonal() + Row::Constant(1e-6 * normal.trace()));
        const Surface next = stepped(best, normal.ldlt().solve(right), u, v);
        const double squares = squares_of(points, next);
        if (!(squares < least))
        {
            damping *= 100.0;
            continue;
        }
        const bool is_done = least - squares <= 1e-6 * least;
        best = next;
        least = squares;
        damping *= 0.1;
        if (is_done)
            break;
    }
    return best;
}

double misfit_of(const Points& points, const Surface& surface)
{
    double worst = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
        const Vector3 point = points.row(i).transpose();
        const double radius = std::max(surface.radius_at(point), 1e-300);
        worst = std::max(worst, surface.distance(point) / radius);
    }
    return worst;
}

}  // namespace sheetmorph::fitting

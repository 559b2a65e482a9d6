// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces/surface_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

// Shares of the spread of normals: below it they lie in a plane through the
// origin, above it they turn at all.
constexpr double flattest = 0.004;
constexpr double turning = 0.002;

struct Spread
{
    Vector3 mean = Vector3::Zero();  // of normals, by area
    Eigen::SelfAdjointEigenSolver<Matrix3> about_zero;
    Eigen::SelfAdjointEigenSolver<Matrix3> about_mean;
};

Spread spread_of(const FacetGraph& graph, const std::vector<int>& triangles)
{
    Spread spread;
    Matrix3 square = Matrix3::Zero();
    double area = 0.0;
    for (const int t : triangles)
    {
        const Vector3 normal = graph.normal(t);
        spread.mean += graph.area(t) * normal;
        square += graph.area(t) * normal * normal.transpose();
        area += graph.area(t);
    }
    spread.mean /= std::max(area, 1e-300);
    square /= std::max(area, 1e-300);
    spread.about_zero.computeDirect(square);
    spread.about_mean.computeDirect(square - spread.mean * spread.mean.transpose());
    return spread;
}

Vector3 middle_of(const FacetGraph& graph, const std::vector<int>& triangles)
{
    Vector3 middle = Vector3::Zero();
    for (const int t : triangles)
        middle += graph.centroid(t) / static_cast<double>(triangles.size());
    return middle;
}

template <typename Visit>
void for_corners(const FacetGraph& graph, const std::vector<int>& triangles, Visit visit)
{
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k)
            visit(graph.point(graph.mesh().triangles()(t, k)));
}

// The sphere |p|^2 = 2 c.p + s with the least squares (Kasa), in the space
// across `axis` if that is not zero: then a cylinder.
std::optional<Surface> ball(const FacetGraph& graph, const std::vector<int>& triangles,
                            const Vector3& axis)
{
    const Vector3 middle = middle_of(graph, triangles);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for_corners(graph, triangles,
                [&](const Vector3& point)
                {
                    const Vector3 off = point - middle;
                    const Vector3 flat = off - axis.dot(off) * axis;
                    Eigen::Vector4d row;
                    row << 2.0 * flat, 1.0;
                    normal += row * row.transpose();
                    right += row * flat.squaredNorm();
                });
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

std::optional<Surface> cylinder(const FacetGraph& graph, const std::vector<int>& triangles)
{
    const Spread spread = spread_of(graph, triangles);
    const Vector3 values = spread.about_zero.eigenvalues();
    if (values(0) > flattest || values(1) < turning)
        return std::nullopt;
    const Vector3 axis = spread.about_zero.eigenvectors().col(0);
    std::optional<Surface> surface = ball(graph, triangles, axis);
    if (surface)
    {
        surface->kind = FeatureKind::cylinder;
        surface->axis = axis;
    }
    return surface;
}

std::optional<Surface> sphere(const FacetGraph& graph, const std::vector<int>& triangles)
{
    const Vector3 values = spread_of(graph, triangles).about_mean.eigenvalues();
    if (values(1) < turning || values(1) < 0.15 * values(2))
        return std::nullopt;
    std::optional<Surface> surface = ball(graph, triangles, Vector3::Zero());
    if (surface)
        surface->kind = FeatureKind::sphere;
    return surface;
}

// All normals make one angle with the axis; every tangent plane goes through
// the apex.
std::optional<Surface> cone(const FacetGraph& graph, const std::vector<int>& triangles)
{
    const Spread spread = spread_of(graph, triangles);
    const Vector3 values = spread.about_mean.eigenvalues();
    Surface surface;
    surface.kind = FeatureKind::cone;
    surface.axis = spread.about_mean.eigenvectors().col(0);
    const double sine = std::abs(spread.mean.dot(surface.axis));
    if (values(0) > 0.2 * flattest || values(1) < turning || sine < 0.06 || sine > 0.98)
        return std::nullopt;
    Matrix3 normal = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
    const Vector3 middle = middle_of(graph, triangles);
    for (const int t : triangles)
    {
        normal += graph.area(t) * graph.normal(t) * graph.normal(t).transpose();
        right += graph.area(t) * graph.normal(t) * graph.normal(t).dot(graph.centroid(t) - middle);
    }
    surface.point = middle + normal.ldlt().solve(right);
    surface.angle = std::asin(sine);
    if (surface.axis.dot(middle - surface.point) < 0.0)
        surface.axis = -surface.axis;
    return surface.point.allFinite() ? std::optional<Surface>(surface) : std::nullopt;
}

std::optional<Surface> plane(const FacetGraph& graph, const std::vector<int>& triangles)
{
    const Spread spread = spread_of(graph, triangles);
    Surface surface;
    surface.axis = spread.about_zero.eigenvectors().col(2);
    if (surface.axis.dot(spread.mean) < 0.0)
        surface.axis = -surface.axis;
    double area = 0.0;
    for (const int t : triangles)
    {
        surface.point += graph.area(t) * graph.centroid(t);
        area += graph.area(t);
    }
    surface.point /= std::max(area, 1e-300);
    return surface;
}

}  // namespace

double Surface::offset(const Vector3& place) const
{
    const Vector3 off = place - point;
    const double along = off.dot(axis);
    const double away = (off - along * axis).norm();
    switch (kind)
    {
        case FeatureKind::cylinder:
            return away - radius;
        case FeatureKind::sphere:
            return off.norm() - radius;
        case FeatureKind::cone:
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
        case FeatureKind::cylinder:
            return out;
        case FeatureKind::sphere:
            return off.normalized();
        case FeatureKind::cone:
            return std::cos(angle) * out - std::sin(angle) * axis;
        default:
            return axis;
    }
}

double Surface::radius_at(const Vector3& place) const
{
    const Vector3 off = place - point;
    return kind == FeatureKind::cone ? (off - off.dot(axis) * axis).norm() : radius;
}

std::optional<Surface> fit_surface(const FacetGraph& graph, const std::vector<int>& triangles,
                                   FeatureKind kind)
{
    if (kind == FeatureKind::cylinder)
        return cylinder(graph, triangles);
    if (kind == FeatureKind::sphere)
        return sphere(graph, triangles);
    return kind == FeatureKind::cone ? cone(graph, triangles) : plane(graph, triangles);
}

}  // namespace sheetmorph

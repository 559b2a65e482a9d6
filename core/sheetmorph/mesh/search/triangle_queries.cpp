// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/triangle_queries.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace sheetmorph::mesh
{

namespace
{

// Squared ratio of height to longest edge, from thinnest_triangle: 1e-5 squared.
constexpr double thin = 1e-10;

Vector3 point_at(const TriangleCorners& corners, const Vector3& barycentric)
{
    return corners[0] * barycentric(0) + corners[1] * barycentric(1) + corners[2] * barycentric(2);
}

void keep_nearer(const Vector3& point, const TriangleCorners& corners, const Vector3& barycentric,
                 Hit& best)
{
    const Vector3 place = point_at(corners, barycentric);
    const double distance = (place - point).norm();
    if (distance < best.distance)
    {
        best.barycentric = barycentric;
        best.distance = distance;
        best.point = place;
    }
}

// The parameter of the point of segment a - b nearest to `point`; 0 at a.
double nearest_on_segment(const Vector3& point, const Vector3& a, const Vector3& b)
{
    const double length = (b - a).squaredNorm();
    return length > 0.0 ? std::clamp((point - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
}

Hit hit_at(const Vector3& point, const TriangleCorners& corners, const Vector3& barycentric)
{
    Hit hit;
    hit.barycentric = barycentric;
    hit.point = point_at(corners, barycentric);
    hit.distance = (hit.point - point).norm();
    return hit;
}

// Handles any triangle, also one degenerate to a segment or a point.
Hit nearest_on_thin_triangle(const Vector3& point, const TriangleCorners& corners)
{
    Hit best;
    best.distance = std::numeric_limits<double>::infinity();
    const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.squaredNorm() > 0.0)
    {
        Vector3 inside;
        for (int k = 0; k < 3; ++k)
            inside(k) =
                normal.dot((corners[(k + 1) % 3] - point).cross(corners[(k + 2) % 3] - point));
        if (inside.minCoeff() >= 0.0 && inside.sum() > 0.0)
            keep_nearer(point, corners, inside / inside.sum(), best);
    }
    for (int k = 0; k < 3; ++k)
    {
        const int next = (k + 1) % 3;
        const double along = nearest_on_segment(point, corners[k], corners[next]);
        Vector3 barycentric = Vector3::Zero();
        barycentric(k) = 1.0 - along;
        barycentric(next) = along;
        keep_nearer(point, corners, barycentric, best);
    }
    return best;
}

}  // namespace

TriangleRay::TriangleRay(const Vector3& origin, const Vector3& direction, double reach)
    : origin_(origin), inverse_(direction.cwiseInverse())
{
    const double slack = rounding * (reach + origin.cwiseAbs().maxCoeff());
    for (int c = 0; c < 3; ++c)
    {
        is_forward_[c] = inverse_(c) >= 0.0;
        enters_from_(c) = origin(c) + (is_forward_[c] ? slack : -slack);
        leaves_from_(c) = origin(c) - (is_forward_[c] ? slack : -slack);
    }
    direction.cwiseAbs().maxCoeff(&z_);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_ = Vector3(direction(x_), direction(y_), 1.0) / direction(z_);
}

bool TriangleRay::meets(const TriangleCorners& corners, Hit& hit) const
{
    double x[3], y[3], z[3];
    for (int k = 0; k < 3; ++k)
    {
        const Vector3 offset = corners[k] - origin_;
        x[k] = offset(x_) - shear_(0) * offset(z_);
        y[k] = offset(y_) - shear_(1) * offset(z_);
        z[k] = shear_(2) * offset(z_);
    }
    Vector3 edge;
    for (int k = 0; k < 3; ++k)
    {
        const int a = (k + 1) % 3;
        const int b = (k + 2) % 3;
        edge(k) = x[b] * y[a] - y[b] * x[a];
    }
    if (edge.minCoeff() < 0.0 && edge.maxCoeff() > 0.0)
        return false;
    const double sum = edge.sum();
    if (sum == 0.0)
        return false;
    hit.barycentric = edge / sum;
    hit.distance = hit.barycentric.dot(Vector3(z[0], z[1], z[2]));
    hit.point = point_at(corners, hit.barycentric);
    return hit.distance >= 0.0;
}

TriangleRay checked_ray(const Vector3& origin, const Vector3& direction, double reach)
{
    if (!origin.allFinite() || !direction.allFinite() || direction.stableNorm() < 1e-300)
        throw InvalidInput("a ray needs a finite origin and a direction that is not zero");
    return TriangleRay(origin, direction.stableNormalized(), reach);
}

std::optional<Hit> first_hit(const Eigen::Ref<const Points>& points,
                             const Eigen::Ref<const Triangles>& triangles, const Vector3& origin,
                             const Vector3& direction)
{
    if (triangles.size() > 0 && (triangles.minCoeff() < 0 || triangles.maxCoeff() >= points.rows()))
        throw InvalidInput("a triangle names a vertex that the mesh does not have");
    const double reach = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0.0;
    const TriangleRay ray = checked_ray(origin, direction, reach);
    std::optional<Hit> best;
    Hit hit;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
        const TriangleCorners corners{points.row(triangles(t, 0)), points.row(triangles(t, 1)),
                                      points.row(triangles(t, 2))};
        if (!ray.meets(corners, hit) || (best && hit.distance >= best->distance))
            continue;
        hit.triangle = static_cast<int>(t);
        best = hit;
    }
    return best;
}

// Distinguishes the Voronoi regions of the triangle (Ericson, Real-Time Collision Detection,
// 5.1.5).
Hit nearest_on_triangle(const Vector3& point, const TriangleCorners& corners)
{
    const Vector3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const Vector3 ap = point - corners[0], bp = point - corners[1], cp = point - corners[2];
    const double longest = std::max(ab.squaredNorm(), ac.squaredNorm());
    if (!(ab.cross(ac).squaredNorm() > thin * longest * longest))
        return nearest_on_thin_triangle(point, corners);
    const double a_b = ab.dot(ap), a_c = ac.dot(ap);
    if (a_b <= 0.0 && a_c <= 0.0)
        return hit_at(point, corners, Vector3::UnitX());
    const double b_b = ab.dot(bp), b_c = ac.dot(bp);
    if (b_b >= 0.0 && b_c <= b_b)
        return hit_at(point, corners, Vector3::UnitY());
    const double c_b = ab.dot(cp), c_c = ac.dot(cp);
    if (c_c >= 0.0 && c_b <= c_c)
        return hit_at(point, corners, Vector3::UnitZ());
    const double of_c = a_b * b_c - b_b * a_c;
    if (of_c <= 0.0 && a_b >= 0.0 && b_b <= 0.0)
    {
        const double along = a_b / (a_b - b_b);
        return hit_at(point, corners, {1.0 - along, along, 0.0});
    }
    const double of_b = c_b * a_c - a_b * c_c;
    if (of_b <= 0.0 && a_c >= 0.0 && c_c <= 0.0)
    {
        const double along = a_c / (a_c - c_c);
        return hit_at(point, corners, {1.0 - along, 0.0, along});
    }
    const double of_a = b_b * c_c - c_b * b_c;
    if (of_a <= 0.0 && b_c >= b_b && c_b >= c_c)
    {
        const double along = (b_c - b_b) / ((b_c - b_b) + (c_b - c_c));
        return hit_at(point, corners, {0.0, 1.0 - along, along});
    }
    const double sum = of_a + of_b + of_c;
    return hit_at(point, corners, {of_a / sum, of_b / sum, of_c / sum});
}

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "surface/strip.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace sheetmorph::surface::cases
{

constexpr double degree = shapes::pi / 180.0;

// A strip of 300 x 100 mm with three holes, held at x = 0, its handle at x = 300.
inline Case strip_with_holes(bool is_curved = false)
{
    const shapes::PlateWithHoles made = shapes::plate_with_holes({3, 32, 8, 100.0, 20.0});
    const auto bend = [](const Vector3& p)
    { return Vector3(p.x(), p.y(), 12.0 * std::sin(shapes::pi * p.y() / 100.0)); };
    Case one =
        plate("strip with holes", is_curved ? shapes::mapped(made.mesh, bend) : made.mesh, made);
    for (FormFeature& feature : one.constraints.features)
        feature.rotation = FeatureRotation::free;
    one.targets.handles = {RigidMotion{{0.0, 0.0, 60.0}, Vector3::Zero(), Vector3::Zero()}};
    return one;
}

inline void set_rotation(Case& one, FeatureRotation rotation)
{
    for (FormFeature& feature : one.constraints.features)
        feature.rotation = rotation;
}

inline double height_at(const Case& one, const Points& shape, double x)
{
    int nearest = 0;
    (one.mesh.points().rowwise() - Eigen::RowVector3d(x, 0.0, 0.0))
        .rowwise()
        .norm()
        .minCoeff(&nearest);
    return shape(nearest, 2) - one.mesh.points()(nearest, 2);
}

inline double tilt(const RigidMotion& motion)
{
    return std::acos(std::min(1.0, motion.rotation()(2, 2))) / degree;
}

inline Vector3 centre_of(const Case& one, std::size_t feature)
{
    Vector3 sum = Vector3::Zero();
    for (const int vertex : one.constraints.features[feature].vertices)
        sum += one.mesh.points().row(vertex).transpose();
    return sum / static_cast<double>(one.constraints.features[feature].vertices.size());
}

// Squared change of the normals' angle over all edges inside the sheet: how it bends.
inline double bending(const Case& one, const Points& shape)
{
    std::map<std::pair<int, int>, std::vector<int>> edges;
    const Triangles& triangles = one.mesh.triangles();
    for (int t = 0; t < one.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            edges[std::minmax(triangles(t, k), triangles(t, (k + 1) % 3))].push_back(t);
    const auto normal = [&](const Points& points, int t)
    {
        const Vector3 a = points.row(triangles(t, 0)).transpose();
        return Vector3((points.row(triangles(t, 1)).transpose() - a)
                           .cross(points.row(triangles(t, 2)).transpose() - a)
                           .normalized());
    };
    double sum = 0.0;
    for (const auto& edge : edges)
    {
        const std::vector<int>& sides = edge.second;
        if (sides.size() == 2)
        {
            const auto angle = [&](const Points& points) {
                return std::acos(
                    std::min(1.0, normal(points, sides[0]).dot(normal(points, sides[1]))));
            };
            sum += std::pow(angle(shape) - angle(one.mesh.points()), 2);
        }
    }
    return sum;
}

}  // namespace sheetmorph::surface::cases

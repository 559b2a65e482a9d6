// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/surface_deformer.h"
#include "shapes.h"

#include <ostream>

namespace sheetmorph::surface::cases
{

//! A part with constraints and one pose of it.
struct Case
{
    std::string name;
    mesh::TriangleMesh mesh;
    SurfaceConstraints constraints;
    SurfaceTargets targets;
};

inline std::ostream& operator<<(std::ostream& out, const Case& one)
{
    return out << one.name;
}

template <typename Condition>
KnownRegion region(const std::string& name, const mesh::TriangleMesh& mesh, Condition condition)
{
    return {name, shapes::vertices_where(mesh, condition),
            name == "root" ? "fixed region" : "handle"};
}

inline RigidMotion motion(const Vector3& shift, const Vector3& axis, double degrees,
                          const Vector3& pivot)
{
    return {shift, rotation_log(axis, degrees * shapes::pi / 180.0), pivot};
}

// The vertices nearest to `centre`, as one feature.
inline FormFeature patch(const std::string& name, const mesh::TriangleMesh& mesh,
                         const Vector3& centre, double radius)
{
    return {name,
            shapes::vertices_where(mesh,
                                   [&](const Vector3& p) { return (p - centre).norm() < radius; }),
            FeatureRotation::interpolated, "feature"};
}

inline Case plate(const std::string& name, mesh::TriangleMesh mesh,
                  const shapes::PlateWithHoles& plate)
{
    Case one{name, std::move(mesh), {}, {}};
    one.constraints.fixed = {{"root", plate.left, "fixed region"}};
    one.constraints.handles = {{"tip", plate.right, "handle"}};
    for (std::size_t k = 0; k < plate.rims.size(); ++k)
    {
        one.constraints.features.push_back(
            {"hole" + std::to_string(k), plate.rims[k], FeatureRotation::interpolated, "feature"});
        one.targets.feature_logs.emplace_back(Vector3::Zero());
    }
    const Vector3 pivot = one.mesh.points().row(plate.right.front()).transpose();
    one.targets.handles = {motion({-4.0, 3.0, 25.0}, {0.2, 1.0, 0.1}, 35.0, pivot)};
    return one;
}

inline Case flat_plate()
{
    const shapes::PlateWithHoles made = shapes::plate_with_holes();
    return plate("flat_plate", made.mesh, made);
}

inline Case bent_plate()
{
    const shapes::PlateWithHoles made = shapes::plate_with_holes();
    const auto bend = [](const Vector3& p)
    {
        const double angle = p.x() / 120.0;
        return Vector3(120.0 * std::sin(angle), p.y(), 120.0 * (1.0 - std::cos(angle)));
    };
    return plate("bent_plate", shapes::mapped(made.mesh, bend), made);
}

}  // namespace sheetmorph::surface::cases

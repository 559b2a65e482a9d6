// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "surface/cases.h"

namespace sheetmorph::surface::cases
{

//! Held at the bottom of z, moved at its top, one feature at the side.
inline Case closed_or_tube(const std::string& name, mesh::TriangleMesh mesh)
{
    Case one{name, std::move(mesh), {}, {}};
    const double low = one.mesh.points().col(2).minCoeff();
    const double high = one.mesh.points().col(2).maxCoeff();
    const double slice = 0.12 * (high - low);
    one.constraints.fixed = {
        region("root", one.mesh, [&](const Vector3& p) { return p.z() < low + slice; })};
    one.constraints.handles = {
        region("tip", one.mesh, [&](const Vector3& p) { return p.z() > high - slice; })};
    int side = 0;
    (one.mesh.points().rowwise() - Eigen::RowVector3d(1e3, 0.0, 0.5 * (low + high)))
        .rowwise()
        .norm()
        .minCoeff(&side);
    one.constraints.features = {
        patch("boss", one.mesh, one.mesh.points().row(side).transpose(), 0.25 * (high - low))};
    one.targets.feature_logs = {Vector3::Zero()};
    one.targets.handles = {
        motion({6.0, -3.0, 4.0}, {1.0, 0.3, 0.5}, 40.0, Vector3(1.0, 2.0, high))};
    return one;
}

inline Case graded_sheet()
{
    Case one{"graded_sheet", shapes::graded_grid(40, 8, 200.0, 1.8), {}, {}};
    one.constraints.fixed = {
        region("root", one.mesh, [](const Vector3& p) { return p.x() < 1.0; })};
    one.constraints.handles = {
        region("tip", one.mesh, [](const Vector3& p) { return p.x() > 190.0; })};
    one.constraints.features = {patch("boss", one.mesh, {90.0, 25.0, 0.0}, 14.0)};
    one.targets.feature_logs = {Vector3::Zero()};
    one.targets.handles = {motion({-10.0, 0.0, 40.0}, {0.0, 1.0, 0.0}, -50.0, {195.0, 0.0, 0.0})};
    return one;
}

//! Shapes closed and open, coarse and fine, flat and curved, regular, graded and jittered.
inline std::vector<Case> all()
{
    std::vector<Case> cases = {flat_plate(),
                               bent_plate(),
                               graded_sheet(),
                               closed_or_tube("cylinder", shapes::cylinder(24, 12, 30.0, 100.0)),
                               closed_or_tube("sphere", shapes::sphere(3, 50.0)),
                               closed_or_tube("coarse_sphere", shapes::sphere(2, 50.0)),
                               closed_or_tube("box", shapes::box(6, {60.0, 40.0, 80.0}))};
    Case jittered = closed_or_tube("jittered_cylinder",
                                   shapes::jittered(shapes::cylinder(30, 14, 30.0, 100.0), 1.0, 7));
    cases.push_back(jittered);
    return cases;
}

//! Every case with every energy, and one of them on intrinsic triangles.
inline std::vector<Case> all_with_every_energy()
{
    std::vector<Case> cases;
    const char* const names[] = {"_paper", "_neumann", "_natural"};
    for (const Case& one : all())
        for (const Energy energy : {Energy::paper, Energy::neumann, Energy::natural})
            for (const Laplacian laplacian : {Laplacian::cotangent, Laplacian::intrinsic})
            {
                const bool is_intrinsic = laplacian == Laplacian::intrinsic;
                if (is_intrinsic && one.name != "jittered_cylinder")
                    continue;
                cases.push_back(one);
                cases.back().constraints.energy = energy;
                cases.back().constraints.laplacian = laplacian;
                cases.back().name += names[static_cast<int>(energy)];
                cases.back().name += is_intrinsic ? "_intrinsic" : "";
            }
    return cases;
}

//! The same with features that the energy turns.
inline std::vector<Case> with_free_features(std::vector<Case> cases)
{
    for (Case& one : cases)
        for (FormFeature& feature : one.constraints.features)
            feature.rotation = FeatureRotation::free;
    return cases;
}

}  // namespace sheetmorph::surface::cases

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "surface/strip.h"

namespace sheetmorph::surface::cases
{

//! A strip of 100 x 25 mm, uniform or finer towards x = 0 by x = 100 u^1.6, its tip lifted by 10
//! mm.
inline Case lifted_strip(Energy energy, int elements, bool is_graded)
{
    Case one = strip(elements);
    if (is_graded)
        one.mesh = shapes::mapped(one.mesh, [](const Vector3& p)
                                  { return Vector3(p.x() * (0.25 + 0.0075 * p.x()), p.y(), 0.0); });
    const auto near = [](double limit) { return [=](const Vector3& p) { return p.x() < limit; }; };
    one.constraints.energy = energy;
    one.constraints.fixed = {region("root", one.mesh, near(1e-6))};
    one.constraints.handles = {
        region("tip", one.mesh, [](const Vector3& p) { return p.x() > 100.0 - 1e-6; })};
    return one;
}

//! Largest error of the z displacement of the free vertices against `exact`, of 1 mm.
template <typename Exact>
double worst_height_error(const Case& one, const Points& shape, Exact exact)
{
    double worst = 0.0;
    for (int i = 0; i < one.mesh.vertex_count(); ++i)
        worst = std::max(worst, std::abs(shape(i, 2) - one.mesh.points()(i, 2)
                                         - exact(one.mesh.points().row(i))));
    return worst;
}

//! Against 3 s^2 - 2 s^3, relative to the lift.
inline double clamped_strip_error(Energy energy, int elements, bool is_graded)
{
    const Case one = lifted_strip(energy, elements, is_graded);
    return 0.1
           * worst_height_error(one, solve(one).positions,
                                [](const Eigen::RowVector3d& p)
                                {
                                    const double s = p.x() / 100.0;
                                    return 10.0 * s * s * (3.0 - 2.0 * s);
                                });
}

//! A cantilever: clamped at x = 0, three points of its tip are lifted by 10 mm, so that the tip may
//! turn. Against (3 s^2 - s^3) / 2, relative to the lift.
inline double cantilever_error(Energy energy, int elements, bool is_graded)
{
    Case one = lifted_strip(energy, elements, is_graded);
    one.constraints.handles.clear();
    one.targets.handles.clear();
    const Triangles& t = one.mesh.triangles();
    for (int f = 0; f < t.rows(); ++f)
        for (int k = 0; k < 3; ++k)
        {
            const Eigen::RowVector3d a = one.mesh.points().row(t(f, k));
            const Eigen::RowVector3d b = one.mesh.points().row(t(f, (k + 1) % 3));
            if (a.x() < 100.0 - 1e-6 || b.x() < 100.0 - 1e-6)
                continue;
            Vector3 middle = Vector3::Zero();
            middle(k) = 0.5;
            middle((k + 1) % 3) = 0.5;
            one.constraints.points.push_back({"tip" + std::to_string(f), f, middle, false});
            one.targets.points.push_back(
                {0.5 * (a + b).transpose() + Vector3(0.0, 0.0, 10.0), Vector3::Zero()});
        }
    return 0.1
           * worst_height_error(one, solve(one).positions,
                                [](const Eigen::RowVector3d& p)
                                {
                                    const double s = p.x() / 100.0;
                                    return 5.0 * s * s * (3.0 - s);
                                });
}

}  // namespace sheetmorph::surface::cases

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "surface/analytic.h"

namespace sheetmorph::surface::cases
{

//! A round plate of radius 50 mm, its rim held, its middle lifted by 1 mm:
//! 1 - r^2 + 2 r^2 ln r.
inline double round_plate_error(Energy energy, int rings, double power)
{
    const int around = 4 * rings;
    Points points(1 + around * rings, 3);
    points.row(0).setZero();
    for (int ring = 1; ring <= rings; ++ring)
        for (int k = 0; k < around; ++k)
        {
            const double r = 50.0 * std::pow(double(ring) / rings, power);
            const double angle = 2.0 * shapes::pi * k / around;
            points.row(1 + (ring - 1) * around + k) << r * std::cos(angle), r * std::sin(angle), 0;
        }
    Triangles triangles(around * (2 * rings - 1), 3);
    for (int k = 0; k < around; ++k)
        triangles.row(k) << 0, 1 + k, 1 + (k + 1) % around;
    const Triangles outer = shapes::cell_triangles({around, rings - 1, true, false});
    triangles.bottomRows(outer.rows()) = outer.array() + 1;
    Case one{"round_plate", mesh::TriangleMesh(points, triangles), {}, {}};
    one.constraints.energy = energy;
    one.constraints.fixed = {
        region("root", one.mesh, [](const Vector3& p) { return p.norm() > 49.999; })};
    one.constraints.points = {{"middle", 0, {1.0, 0.0, 0.0}, false}};
    one.targets.points = {{{0.0, 0.0, 1.0}, Vector3::Zero()}};
    return worst_height_error(one, solve(one).positions,
                              [](const Eigen::RowVector3d& p)
                              {
                                  const double r = p.norm() / 50.0;
                                  return r == 0.0 ? 1.0 : 1.0 - r * r + 2.0 * r * r * std::log(r);
                              });
}

}  // namespace sheetmorph::surface::cases

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <Eigen/Geometry>

namespace sheetmorph::mesh
{

//! Twice the area of a triangle along its normal, mm^2.
inline Vector3 doubled_area(const TriangleMesh& mesh, int triangle)
{
    const auto corner = [&](int k) -> Vector3
    { return mesh.points().row(mesh.triangles()(triangle, k)).transpose(); };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

}  // namespace sheetmorph::mesh

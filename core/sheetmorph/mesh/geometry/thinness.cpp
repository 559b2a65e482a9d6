// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/thinness.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph::mesh
{

bool is_thin(const Points& points, const Triangles& triangles, int triangle)
{
    const Eigen::RowVector3i corners = triangles.row(triangle);
    const Vector3 a = points.row(corners(1)) - points.row(corners(0));
    const Vector3 b = points.row(corners(2)) - points.row(corners(0));
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return a.cross(b).norm() <= thinnest_triangle * longest;
}

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/geometry/normals.h"

#include <Eigen/Geometry>

namespace sheetmorph::mesh
{

namespace
{

// Sum of the normals relative to the summed area. From rounding (1e-16), with a margin so that six
// digits of the direction are left.
constexpr double cancelled = 1e-10;

Vector3 area_vector(const Points& points, const Triangles& triangles, int t)
{
    const Vector3 corner = points.row(triangles(t, 0));
    const Vector3 a = points.row(triangles(t, 1)).transpose() - corner;
    const Vector3 b = points.row(triangles(t, 2)).transpose() - corner;
    return a.cross(b);
}

// The area vector of the largest triangle at each vertex, used where the sum cancels.
Points largest_area_vectors(const Points& points, const Triangles& triangles)
{
    Points largest = Points::Zero(points.rows(), 3);
    for (int t = 0; t < triangles.rows(); ++t)
    {
        const Vector3 area = area_vector(points, triangles, t);
        for (int k = 0; k < 3; ++k)
            if (area.squaredNorm() > largest.row(triangles(t, k)).squaredNorm())
                largest.row(triangles(t, k)) = area.transpose();
    }
    return largest;
}

}  // namespace

Points vertex_normals(const Points& points, const Triangles& triangles)
{
    Points normals = Points::Zero(points.rows(), 3);
    Eigen::VectorXd scale = Eigen::VectorXd::Zero(points.rows());
    for (int t = 0; t < triangles.rows(); ++t)
    {
        const Vector3 area = area_vector(points, triangles, t);
        const double size = area.norm();
        for (int k = 0; k < 3; ++k)
        {
            normals.row(triangles(t, k)) += area.transpose();
            scale(triangles(t, k)) += size;
        }
    }
    const Eigen::VectorXd lengths = normals.rowwise().norm();
    const bool has_cancelled = (lengths.array() <= cancelled * scale.array()).any();
    const Points largest = has_cancelled ? largest_area_vectors(points, triangles) : Points();
    for (Eigen::Index i = 0; i < normals.rows(); ++i)
        if (lengths(i) > cancelled * scale(i))
            normals.row(i) /= lengths(i);
        else if (scale(i) > 0.0)
            normals.row(i) = largest.row(i).stableNormalized();
        else
            normals.row(i) = Eigen::RowVector3d::UnitZ();
    return normals;
}

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sheetmorph::volume
{

// The scalar textbook weights in extended precision, for points well off every triangle's plane.
inline Eigen::VectorXd textbook_weights(const Points& vertices, const Triangles& triangles,
                                        const Vector3& point)
{
    using Vector = Eigen::Matrix<long double, 3, 1>;
    Eigen::Matrix<long double, Eigen::Dynamic, 1> weights =
        Eigen::Matrix<long double, Eigen::Dynamic, 1>::Zero(vertices.rows());
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
        Vector unit[3], normal[3], mean = Vector::Zero();
        long double distance[3];
        for (int k = 0; k < 3; ++k)
        {
            const Vector arm = vertices.row(triangles(t, k)).transpose().cast<long double>()
                               - point.cast<long double>();
            distance[k] = arm.norm();
            unit[k] = arm / distance[k];
        }
        for (int k = 0; k < 3; ++k)
        {
            const Vector cross = unit[(k + 1) % 3].cross(unit[(k + 2) % 3]);
            const long double cosine = unit[(k + 1) % 3].dot(unit[(k + 2) % 3]);
            normal[k] = cross / cross.norm();
            mean += 0.5L * std::atan2(cross.norm(), cosine) * normal[k];
        }
        for (int k = 0; k < 3; ++k)
            weights(triangles(t, k)) +=
                normal[k].dot(mean) / (distance[k] * normal[k].dot(unit[k]));
    }
    return (weights / weights.sum()).cast<double>();
}

}  // namespace sheetmorph::volume

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/log_near.h"
#include "sheetmorph/mesh/search/picking.h"

#include <array>

namespace sheetmorph::mesh
{

//! A point of a triangle to which something is attached: beta_0 p_0 + beta_1 p_1 + beta_2 p_2. The
//! three vertices may be the same.
struct Anchor
{
    std::array<int, 3> corners{};
    Vector3 weights = Vector3::Zero();

    static Anchor at_vertex(int vertex) { return {{vertex, vertex, vertex}, Vector3::UnitX()}; }

    //! The hit point on rows of `triangles`.
    static Anchor at(const Hit& hit, const Triangles& triangles)
    {
        const auto corners = triangles.row(hit.triangle);
        return {{corners(0), corners(1), corners(2)}, hit.barycentric};
    }

    //! The corner with the largest weight.
    int heaviest() const
    {
        Eigen::Index corner = 0;
        weights.maxCoeff(&corner);
        return corners[static_cast<std::size_t>(corner)];
    }

    //! The weighted sum of the corners' vectors.
    template <typename OfCorner>
    Vector3 sum(OfCorner of_corner) const
    {
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            sum += weights(static_cast<Eigen::Index>(k)) * of_corner(corners[k]);
        return sum;
    }

    //! The value at the point, interpolated from rows of `values` (n, 3): positions or rotation
    //! logs.
    Vector3 on(const Points& values) const
    {
        return sum([&](int corner) { return Vector3(values.row(corner)); });
    }

    //! The weighted mean of the corners' matrices; bitwise equal to them if they are all equal.
    template <typename OfCorner>
    Matrix3 mean(OfCorner of_corner) const
    {
        const Matrix3& first = of_corner(corners[0]);
        Matrix3 change = Matrix3::Zero();
        for (std::size_t k = 1; k < 3; ++k)
            change += weights(static_cast<Eigen::Index>(k)) * (of_corner(corners[k]) - first);
        return first + change;
    }

    //! The rotation at the point; bitwise equal to that of the corners if they are all equal.
    template <typename OfCorner>
    Matrix3 rotation(OfCorner of_corner) const
    {
        const Matrix3 found = mean(of_corner);
        return found == of_corner(corners[0]) ? found : polar_rotation(found);
    }
};

}  // namespace sheetmorph::mesh

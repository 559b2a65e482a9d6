// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/log_near.h"
#include "sheetmorph/mesh/search/picking.h"

#include <array>

namespace sheetmorph::mesh
{

//! What hangs on a sheet hangs on a point of one triangle: beta_0 p_0 + beta_1 p_1 + beta_2 p_2
//! over three vertices, which may be one and the same.
struct Anchor
{
    std::array<int, 3> corners{};
    Vector3 weights = Vector3::Zero();

    static Anchor at_vertex(int vertex) { return {{vertex, vertex, vertex}, Vector3::UnitX()}; }

    //! The place that was hit on rows of `triangles`.
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

    //! The sum of what its corners have, each times its weight.
    template <typename OfCorner>
    Vector3 sum(OfCorner of_corner) const
    {
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            sum += weights(static_cast<Eigen::Index>(k)) * of_corner(corners[k]);
        return sum;
    }

    //! The point on rows of `values` (n, 3): positions, or rotation logs.
    Vector3 on(const Points& values) const
    {
        return sum([&](int corner) { return Vector3(values.row(corner)); });
    }

    //! The mean of the matrices of its corners; exactly theirs where they agree.
    template <typename OfCorner>
    Matrix3 mean(OfCorner of_corner) const
    {
        const Matrix3& first = of_corner(corners[0]);
        Matrix3 change = Matrix3::Zero();
        for (std::size_t k = 1; k < 3; ++k)
            change += weights(static_cast<Eigen::Index>(k)) * (of_corner(corners[k]) - first);
        return first + change;
    }

    //! The rotation of its frame; exactly that of its corners where they agree.
    template <typename OfCorner>
    Matrix3 rotation(OfCorner of_corner) const
    {
        const Matrix3 found = mean(of_corner);
        return found == of_corner(corners[0]) ? found : polar_rotation(found);
    }
};

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"

#include <array>
#include <limits>

namespace sheetmorph::mesh
{

using TriangleCorners = std::array<Vector3, 3>;

//! A ray prepared for watertight tests (Woop, Benthin, Wald 2013). The tests shear triangles into a
//! frame whose third axis is the ray. Two triangles that share an edge then compute identical
//! values along it.
class TriangleRay
{
public:
    //! \param direction  of length 1
    //! \param reach      largest coordinate of anything the ray is tested against
    TriangleRay(const Vector3& origin, const Vector3& direction, double reach);

    //! Distance at which the ray enters a box widened by the rounding of the test: 0 inside,
    //! infinite if the ray misses.
    double entry(const Vector3& low, const Vector3& high) const
    {
        double enter = 0.0;
        double leave = std::numeric_limits<double>::infinity();
        for (int c = 0; c < 3; ++c)
        {
            // These comparisons ignore the NaN of a ray in the plane of a side.
            const double from = ((is_forward_[c] ? low : high)(c)-enters_from_(c)) * inverse_(c);
            const double to = ((is_forward_[c] ? high : low)(c)-leaves_from_(c)) * inverse_(c);
            enter = from > enter ? from : enter;
            leave = to < leave ? to : leave;
        }
        const bool is_hit = enter * (1.0 - rounding) <= leave * (1.0 + rounding);
        return is_hit ? enter * (1.0 - rounding) : std::numeric_limits<double>::infinity();
    }

    //! Whether the ray hits a triangle from either side, its border included. Sets barycentric,
    //! distance and point of `hit`.
    bool meets(const TriangleCorners& corners, Hit& hit) const;

private:
    //! Relative rounding error of the tests: about five operations on coordinates, each exact to
    //! half an epsilon, with a margin of six.
    static constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

    Vector3 origin_;
    Vector3 inverse_;
    Vector3 enters_from_, leaves_from_;  // the origin, shifted to widen boxes
    Vector3 shear_;
    bool is_forward_[3];
    int x_, y_, z_;
};

//! A ray with a direction of any length.
//! \throws InvalidInput for a direction of length zero or values that are not finite
TriangleRay checked_ray(const Vector3& origin, const Vector3& direction, double reach);

//! As PickingTree::nearest_hit(), without a tree: for a single query of a shape.
//! \param points     (n, 3) mm, finite
//! \param triangles  (m, 3)
//! \throws InvalidInput for a ray of length zero or not finite, and for vertices that do not exist
std::optional<Hit> first_hit(const Eigen::Ref<const Points>& points,
                             const Eigen::Ref<const Triangles>& triangles, const Vector3& origin,
                             const Vector3& direction);

//! The point of a triangle nearest to `point`; sets barycentric, distance and point. A degenerate
//! triangle counts as the segment or point it is.
Hit nearest_on_triangle(const Vector3& point, const TriangleCorners& corners);

}  // namespace sheetmorph::mesh

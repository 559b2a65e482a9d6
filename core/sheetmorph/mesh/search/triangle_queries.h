// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"

#include <array>
#include <limits>

namespace sheetmorph::mesh
{

using TriangleCorners = std::array<Vector3, 3>;

//! A ray prepared for watertight tests (Woop, Benthin, Wald 2013): triangles are sheared into a
//! frame in which the ray is the third axis, where two triangles that share an edge see the very
//! same numbers along it.
class TriangleRay
{
public:
    //! \param direction  of length 1
    //! \param reach      largest coordinate of anything the ray will be tested with
    TriangleRay(const Vector3& origin, const Vector3& direction, double reach);

    //! Distance at which the ray enters a box, widened by the rounding of the test; 0 inside it,
    //! infinite if it misses.
    double entry(const Vector3& low, const Vector3& high) const
    {
        double enter = 0.0;
        double leave = std::numeric_limits<double>::infinity();
        for (int c = 0; c < 3; ++c)
        {
            // Written so that the NaN of a ray in the plane of a side changes nothing.
            const double from = ((is_forward_[c] ? low : high)(c)-enters_from_(c)) * inverse_(c);
            const double to = ((is_forward_[c] ? high : low)(c)-leaves_from_(c)) * inverse_(c);
            enter = from > enter ? from : enter;
            leave = to < leave ? to : leave;
        }
        const bool is_hit = enter * (1.0 - rounding) <= leave * (1.0 + rounding);
        return is_hit ? enter * (1.0 - rounding) : std::numeric_limits<double>::infinity();
    }

    //! Whether the ray meets a triangle, from either side, its border included; sets barycentric,
    //! distance and point.
    bool meets(const TriangleCorners& corners, Hit& hit) const;

private:
    //! Relative error of what the tests compute, with room to spare.
    static constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

    Vector3 origin_;
    Vector3 inverse_;
    Vector3 enters_from_, leaves_from_;  // the origin, moved so that boxes are widened
    Vector3 shear_;
    bool is_forward_[3];
    int x_, y_, z_;
};

//! A ray with a direction of any length.
//! \throws InvalidInput for a direction of length zero or anything not finite
TriangleRay checked_ray(const Vector3& origin, const Vector3& direction, double reach);

//! What PickingTree::nearest_hit answers, without a tree: for a shape that is asked only once.
//! \param points  (n, 3) mm, finite; \param triangles (m, 3)
//! \throws InvalidInput for a ray of length zero or not finite, and a triangle without its vertices
std::optional<Hit> first_hit(const Eigen::Ref<const Points>& points,
                             const Eigen::Ref<const Triangles>& triangles, const Vector3& origin,
                             const Vector3& direction);

//! The place on a triangle nearest to a point: barycentric, distance and point are set. Degenerate
//! triangles are the line or the point they are.
Hit nearest_on_triangle(const Vector3& point, const TriangleCorners& corners);

}  // namespace sheetmorph::mesh

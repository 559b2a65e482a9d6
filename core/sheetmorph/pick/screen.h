// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"

namespace sheetmorph::pick
{

using Matrix4 = Eigen::Matrix4d;

//! (k, 2) points on the screen, px from the lower left corner.
using ScreenPoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

//! Maps space to the screen for a parallel or a perspective camera.
class Screen
{
public:
    //! \param to_clip        (4, 4) from (x, y, z, 1), mm, to OpenGL's clip coordinates
    //! \param width, height  of the view, px
    //! \throws InvalidInput for numbers that are not finite, or a view without extent
    Screen(const Matrix4& to_clip, double width, double height);

    //! x, y in px, and a depth that grows away from the eye. The depth is -1 and 1 on the clipping
    //! planes and linear over every flat triangle. All components are infinite for a point behind
    //! the eye.
    Vector3 seen(const Vector3& point) const;

    //! Planes around the part of space seen in a box (px, px, depth), as
    //! PickingTree::triangles_between() expects them: between low and high in x and y, in front of
    //! the eye, not beyond high in depth.
    mesh::Planes planes_around(const Vector3& low, const Vector3& high) const;

private:
    Matrix4 to_clip_;
    Eigen::Vector2d half_;  // half of width and height, px
};

//! A closed polygon on the screen. A point is inside if its winding number is not 0; the polygon
//! may cross itself.
class ScreenOutline
{
public:
    //! \param corners  (k, 2) px, k >= 3; the last is joined to the first
    //! \throws InvalidInput for fewer corners, or numbers that are not finite
    explicit ScreenOutline(ScreenPoints corners);

    bool contains(double x, double y) const;

    //! The bounding rectangle, over all depths.
    Vector3 low() const { return {low_.x(), low_.y(), -1.0}; }
    Vector3 high() const { return {high_.x(), high_.y(), 1.0}; }

private:
    int row_of(double y) const;

    ScreenPoints corners_;
    Eigen::Vector2d low_, high_;
    // By row: the sides that reach into it; equal rows from low to high.
    std::vector<std::vector<int>> sides_;
};

}  // namespace sheetmorph::pick

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/pick/screen.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/limits.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace sheetmorph::pick
{

namespace
{

constexpr int rows_of_an_outline = 256;  // chosen: a row of a full screen is about four pixels

// Pixels, and depth from -1 to 1: margins that shift the planes outwards. From rounding: places on
// a screen of 1e4 pixels are exact to 1e-12, depths to 1e-16. Chosen a million times larger.
constexpr double margin = 1e-6;
constexpr double depth_margin = 1e-9;

}  // namespace

Screen::Screen(const Matrix4& to_clip, double width, double height)
    : to_clip_(to_clip), half_(0.5 * width, 0.5 * height)
{
    if (!are_numbers(to_clip))
        throw InvalidInput("the matrix of the camera has entries that are not finite numbers");
    if (!(half_.minCoeff() > 0.0) || !are_numbers(half_))
        throw InvalidInput("the view has no extent", "its width and height must be positive");
}

Vector3 Screen::seen(const Vector3& point) const
{
    const Eigen::Vector4d clip = to_clip_.leftCols<3>() * point + to_clip_.col(3);
    if (!(clip.w() > 0.0))
        return Vector3::Constant(std::numeric_limits<double>::infinity());
    const Vector3 unit = clip.head<3>() / clip.w();
    return {(unit.x() + 1.0) * half_.x(), (unit.y() + 1.0) * half_.y(), unit.z()};
}

mesh::Planes Screen::planes_around(const Vector3& low, const Vector3& high) const
{
    mesh::Planes planes(6, 4);
    for (int c = 0; c < 2; ++c)
    {
        const double from = (low(c) - margin) / half_(c) - 1.0;
        const double to = (high(c) + margin) / half_(c) - 1.0;
        planes.row(2 * c) = to_clip_.row(c) - from * to_clip_.row(3);
        planes.row(2 * c + 1) = to * to_clip_.row(3) - to_clip_.row(c);
    }
    planes.row(4) = to_clip_.row(3);
    planes.row(5) = (high.z() + depth_margin) * to_clip_.row(3) - to_clip_.row(2);
    return planes;
}

ScreenOutline::ScreenOutline(ScreenPoints corners) : corners_(std::move(corners))
{
    if (corners_.rows() < 3 || !are_numbers(corners_))
        throw InvalidInput("an outline needs three or more corners with finite coordinates",
                           "it has " + std::to_string(corners_.rows()));
    low_ = corners_.colwise().minCoeff();
    high_ = corners_.colwise().maxCoeff();
    sides_.resize(rows_of_an_outline);
    for (int k = 0; k < corners_.rows(); ++k)
    {
        const double one = corners_(k, 1);
        const double other = corners_((k + 1) % corners_.rows(), 1);
        for (int row = row_of(std::min(one, other)); row <= row_of(std::max(one, other)); ++row)
            sides_[static_cast<std::size_t>(row)].push_back(k);
    }
}

int ScreenOutline::row_of(double y) const
{
    const double extent = std::max(high_.y() - low_.y(), std::numeric_limits<double>::min());
    const double row = (y - low_.y()) / extent * rows_of_an_outline;
    return static_cast<int>(std::clamp(row, 0.0, rows_of_an_outline - 1.0));
}

// Winding number: a side that crosses the ray to the right of the point counts 1 upwards and -1
// downwards.
bool ScreenOutline::contains(double x, double y) const
{
    if (!(x >= low_.x() && x <= high_.x() && y >= low_.y() && y <= high_.y()))
        return false;
    int turns = 0;
    for (const int k : sides_[static_cast<std::size_t>(row_of(y))])
    {
        const Eigen::Vector2d a = corners_.row(k);
        const Eigen::Vector2d b = corners_.row((k + 1) % corners_.rows());
        if ((a.y() <= y) == (b.y() <= y))
            continue;
        if (x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            turns += a.y() <= y ? 1 : -1;
    }
    return turns != 0;
}

}  // namespace sheetmorph::pick

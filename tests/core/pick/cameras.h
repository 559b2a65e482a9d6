// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Cameras that look down from above the origin, x to the right and y up, on 800 x 600 px.
#include "sheetmorph/pick/screen.h"

namespace sheetmorph::pick::cameras
{

//! 100 mm are seen over the height; clipping planes `depth` mm above and below the origin.
inline Screen parallel_from_above(double depth)
{
    Matrix4 to_clip = Matrix4::Identity();
    to_clip(0, 0) = 600.0 / 800.0 / 50.0;
    to_clip(1, 1) = 1.0 / 50.0;
    to_clip(2, 2) = -1.0 / depth;
    return Screen(to_clip, 800.0, 600.0);
}

//! The eye `height` mm above the origin; clipping planes 1 mm and 2 `height` mm away from it.
inline Screen perspective_from_above(double height)
{
    const double near = 1.0;
    const double far = 2.0 * height;
    Matrix4 to_clip = Matrix4::Zero();
    to_clip(0, 0) = 600.0 / 800.0;
    to_clip(1, 1) = 1.0;
    to_clip(2, 2) = -(far + near) / (far - near);
    to_clip(2, 3) = (far + near) / (far - near) * height - 2.0 * far * near / (far - near);
    to_clip(3, 2) = -1.0;
    to_clip(3, 3) = height;
    return Screen(to_clip, 800.0, 600.0);
}

}  // namespace sheetmorph::pick::cameras

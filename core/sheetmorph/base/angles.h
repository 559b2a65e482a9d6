// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph
{

constexpr double pi = 3.14159265358979323846;  //!< from geometry
constexpr double degree = pi / 180.0;          //!< radians, from geometry

}  // namespace sheetmorph

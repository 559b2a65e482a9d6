// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <gp_Trsf.hxx>
#include <optional>

namespace sheetmorph
{

//! The rigid motion that takes rows of `from` to rows of `to`, none if one is off by more than
//! `tolerance` (mm).
//! \param is_straight  whether a straight row is enough, else points must span a plane
std::optional<gp_Trsf> rigid_fit(const Points& from, const Points& to, double tolerance,
                                 bool is_straight);

//! A point after a motion.
Vector3 moved(const Vector3& point, const gp_Trsf& motion);

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/contacts/part_shape.h"

#include <array>
#include <utility>

namespace sheetmorph::recognise
{

//! The pairs of parts, smaller index first, whose boxes are no farther apart
//! than `reach` and half of both thicknesses; ascending. A sweep along x: not
//! every pair is looked at.
std::vector<std::pair<int, int>> near_pairs(const std::vector<PartShape>& shapes, double reach);

//! Two coaxial holes of different parts.
struct Bolt
{
    int part_a, feature_a;
    int part_b, feature_b;
    double distance = 0.0;  //!< between the nearest rims along the axis, mm
};

//! The pairs of coaxial round holes whose parts lie within `reach` (and half of
//! both thicknesses) of each other there; each hole with the nearest of another
//! part on either side.
std::vector<Bolt> find_bolts(const std::vector<ContactPart>& parts, double reach,
                             const ContactTolerances& tolerances);

}  // namespace sheetmorph::recognise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/contacts/part_shape.h"

#include <array>
#include <utility>

namespace sheetmorph::recognise
{

//! The pairs of parts (smaller index first, ascending) whose boxes are at most `reach` plus half of
//! both thicknesses apart. A sweep along x avoids testing every pair.
std::vector<std::pair<int, int>> near_pairs(const std::vector<PartShape>& shapes, double reach);

//! Two coaxial holes of different parts.
struct Bolt
{
    int part_a, feature_a;
    int part_b, feature_b;
    double distance = 0.0;  //!< axial distance between the nearest rims, mm
};

//! All pairs of coaxial round holes of different parts that are at most `reach` plus half of both
//! thicknesses apart along the axis.
std::vector<Bolt> find_bolts(const std::vector<ContactPart>& parts, double reach,
                             const ContactTolerances& tolerances);

}  // namespace sheetmorph::recognise

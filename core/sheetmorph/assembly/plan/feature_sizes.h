// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/forms/feature_shape.h"

namespace sheetmorph::assembly
{

//! Whether a description or a pose may set the size of a feature.
bool is_sized(const PartFeature& feature);

//! By feature of the assembly: its shape where its size can be set, else nothing.
//! \throws InvalidInput naming a feature that has a size but is no hole, slot or cylinder, or a
//! size that it cannot have
std::vector<std::optional<forms::FeatureShape>> shapes_of_sized(const Assembly& assembly);

//! The size a feature has in a pose: the pose's, else the description's, else none.
std::optional<double> size_in_pose(const PartFeature& feature, const Pose& pose);

//! \throws InvalidInput naming a size that a feature cannot have
void check_sizes(const Assembly& assembly,
                 const std::vector<std::optional<forms::FeatureShape>>& shapes, const Pose& pose);

}  // namespace sheetmorph::assembly

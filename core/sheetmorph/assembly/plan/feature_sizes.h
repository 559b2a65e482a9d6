// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/forms/feature_shape.h"

namespace sheetmorph::assembly
{

//! Whether the assembly or a pose may set the size of a feature.
bool is_sized(const PartFeature& feature);

//! By feature of the assembly: its shape if its size can be set, else nothing.
//! \throws InvalidInput naming a feature with a size that is not a hole, slot or cylinder, or with
//!     an impossible size
std::vector<std::optional<forms::FeatureShape>> shapes_of_sized(const Assembly& assembly);

//! The size of a feature in a pose: that of the pose, else of the assembly, else nothing.
std::optional<double> size_in_pose(const PartFeature& feature, const Pose& pose);

//! \throws InvalidInput naming an impossible size of a feature
void check_sizes(const Assembly& assembly,
                 const std::vector<std::optional<forms::FeatureShape>>& shapes, const Pose& pose);

}  // namespace sheetmorph::assembly

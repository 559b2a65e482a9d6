// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/forms/feature_shape.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"

namespace sheetmorph::surface
{

//! By form feature: its shape if its size may be set.
using FeatureShapes = std::vector<std::optional<forms::FeatureShape>>;

//! Change of size in one pose by form feature, mm; nothing: as at rest.
using SizeChanges = std::vector<std::optional<double>>;

//! Recognises the features whose size may be set.
//! \throws InvalidInput naming features that are not a hole, slot or cylinder, or that share
//!                      vertices with another one
FeatureShapes resizable_shapes(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints);

//! Checks and collects the sizes of a pose.
//! \throws InvalidInput naming features with a size that is too small or may not be set
SizeChanges size_changes(const SurfaceConstraints& constraints, const FeatureShapes& shapes,
                         const SurfaceTargets& targets);

}  // namespace sheetmorph::surface

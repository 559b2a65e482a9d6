// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/forms/feature_shape.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"

namespace sheetmorph::surface
{

//! Of every form feature, what it is if its size may be set.
using FeatureShapes = std::vector<std::optional<forms::FeatureShape>>;

//! Sizes that one pose sets, by form feature: mm more than at rest; nothing: as at rest.
using SizeChanges = std::vector<std::optional<double>>;

//! \throws InvalidInput naming features whose size cannot be set: neither hole, slot nor cylinder,
//! or sharing vertices with another one
FeatureShapes resizable_shapes(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints);

//! \throws InvalidInput naming features whose size is not positive or may not be set
SizeChanges size_changes(const SurfaceConstraints& constraints, const FeatureShapes& shapes,
                         const SurfaceTargets& targets);

}  // namespace sheetmorph::surface

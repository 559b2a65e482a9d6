// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"

namespace sheetmorph::surface
{

//! Checks every region, feature and point individually.
//! \throws InvalidInput for ids out of range, empty regions, invalid barycentric coordinates
void check_constraints(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints);

//! Checks that a pose matches the constraints in shape and contains only finite numbers.
//! \throws InvalidInput naming missing or non-finite items
void check_targets(const SurfaceConstraints& constraints, const SurfaceTargets& targets);

}  // namespace sheetmorph::surface

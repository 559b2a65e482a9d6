// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"
#include "sheetmorph/surface/constraints/targets.h"

namespace sheetmorph::surface
{

//! Checks every region, feature and point by itself.
//! \throws InvalidInput: ids out of range, empty regions, barycentric coordinates that are not
void check_constraints(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints);

//! Checks that a pose has the shape the constraints ask for and only finite numbers.
//! \throws InvalidInput naming what is missing or not finite
void check_targets(const SurfaceConstraints& constraints, const SurfaceTargets& targets);

}  // namespace sheetmorph::surface

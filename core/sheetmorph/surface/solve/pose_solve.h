// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/solve/deformation.h"
#include "sheetmorph/surface/solve/prepared_surface.h"

namespace sheetmorph::surface
{

//! Solves one part in one pose (2.9, 2.10). The energy, the field or the pose
//! determine its features (mathematics.md, section 4).
Deformation solve_pose(const PreparedSurface& part, const SurfaceTargets& targets,
                       Exactness exactness, const Progress& progress = {});

}  // namespace sheetmorph::surface

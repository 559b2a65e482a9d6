// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/forms/rim_profile.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph
{

//! The cylinder that all corners of a mesh's triangles lie on within 2 % of its radius, if there is
//! one, the triangles go around enough of it (30 degrees) to tell, and the fit settles.
std::optional<RimProfile> fit_cylinder(const TriangleMesh& mesh);

}  // namespace sheetmorph

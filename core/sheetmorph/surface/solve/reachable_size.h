// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/solve/deformation.h"
#include "sheetmorph/surface/solve/prepared_surface.h"

namespace sheetmorph::surface
{

//! Triangles that a deformation inverted: their normal points against the rest normal rotated by
//! the sheet's rotation.
std::vector<int> overturned_triangles(const mesh::TriangleMesh& rest,
                                      const Deformation& deformation);

//! Refuses sizes that invert triangles which are not inverted without them.
//! \param unsized  the pose without its sizes
//! \throws InvalidInput naming the feature, the triangles and the nearest possible size
void require_reachable_sizes(const PreparedSurface& part, const SizeChanges& sizes,
                             const Deformation& unsized);

}  // namespace sheetmorph::surface

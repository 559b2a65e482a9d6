// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/solve/deformation.h"
#include "sheetmorph/surface/solve/prepared_surface.h"

namespace sheetmorph::surface
{

//! Triangles that a deformation turned over: their normal is against the one the sheet's rotation
//! there gives them.
std::vector<int> overturned_triangles(const mesh::TriangleMesh& rest,
                                      const Deformation& deformation);

//! Refuses sizes that turn triangles over which stand without them.
//! \param unsized  the pose without its sizes
//! \throws InvalidInput naming the feature, triangles and the size nearest to the wanted one that
//! can be reached
void require_reachable_sizes(const PreparedSurface& part, const SizeChanges& sizes,
                             const Deformation& unsized);

}  // namespace sheetmorph::surface

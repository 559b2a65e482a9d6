// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/geometry/laid_faces.h"

namespace sheetmorph::mesh
{

//! The sum of the cotangents opposite to the worst glued side: not below 0 in an intrinsic
//! Delaunay triangulation; infinite if nothing is glued.
double worst_cotangent_sum(const LaidFaces& faces);

//! Flips glued sides until the faces are intrinsically Delaunay: cotangent sums >= 0 up to
//! rounding. The sheet is unfolded, not moved: vertices, area and distances within it stay. The two
//! new faces lie in the mean plane of the two old ones, weighted by area.
//! Every flip lowers the energy of every function on the sheet, so that no triangulation comes
//! twice; where rounding makes them go on, they end at `most_a_side` flips a side.
//! \returns its rounds are the flips
Convergence flip_to_delaunay(LaidFaces& faces, int most_a_side = 100);

}  // namespace sheetmorph::mesh

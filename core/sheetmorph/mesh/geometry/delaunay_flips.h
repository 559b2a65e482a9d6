// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/geometry/laid_faces.h"

namespace sheetmorph::mesh
{

//! The smallest sum of the two cotangents opposite a glued side. An intrinsic Delaunay
//! triangulation has no negative sum. Infinite if no side is glued.
double worst_cotangent_sum(const LaidFaces& faces);

//! Flips glued sides until the faces are intrinsically Delaunay: all cotangent sums >= 0 up to
//! rounding. Flips unfold the sheet but do not move it: vertices, area and distances within it
//! stay. The two new faces lie in the area-weighted mean plane of the two old ones.
//! Every flip lowers the Dirichlet energy of every function on the sheet, so no triangulation
//! occurs twice. If rounding prevents an end, flips stop at `most_a_side` per side.
//! \returns convergence; its rounds count the flips
Convergence flip_to_delaunay(LaidFaces& faces, int most_a_side = 100);

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! A boundary loop that is a circle.
struct RoundHole
{
    VertexIds rim;  //!< in order, as boundary_loops gives it
    fitting::CircleFit circle;
};

//! The boundary loops of at least 6 vertices whose residual is below tolerance * radius, in the
//! order of boundary_loops; a round outer border is one of them.
//! \param tolerance  no unit, > 0
std::vector<RoundHole> round_holes(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::mesh

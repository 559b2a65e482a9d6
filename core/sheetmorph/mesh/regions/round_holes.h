// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! A circular boundary loop.
struct RoundHole
{
    VertexIds rim;  //!< in the order of boundary_loops()
    fitting::CircleFit circle;
};

//! The boundary loops of at least 6 vertices whose residual from a circle is below tolerance *
//! radius, in the order of boundary_loops(). They include a round outer border.
//! \param tolerance  no unit, > 0
std::vector<RoundHole> round_holes(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::mesh

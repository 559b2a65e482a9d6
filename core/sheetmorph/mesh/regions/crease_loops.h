// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! Whether the sheet ends or breaks at an edge of the table. Such an edge has one triangle or more
//! than two, or its two triangles bend by `angle` (radians) or more.
bool is_crease(const TriangleMesh& mesh, const EdgeTable& table, int edge, double angle);

//! The closed loops of creases: rims of holes through sheets and solids, borders of flats. A loop
//! contains each vertex once, in order, starting at the smallest. No loop passes a vertex at which
//! creases meet or end.
std::vector<VertexIds> crease_loops(const TriangleMesh& mesh, const EdgeTable& table, double angle);

}  // namespace sheetmorph::mesh

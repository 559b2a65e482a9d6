// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! Whether the sheet ends or breaks at an edge of the table: one triangle uses it, three or more
//! do, or it bends by `angle` radians or more between two.
bool is_crease(const TriangleMesh& mesh, const EdgeTable& table, int edge, double angle);

//! The closed loops of such edges: rims of holes through sheets and solids, borders of flats. Each
//! vertex once, in order, the smallest first; where creases meet or end no loop passes.
std::vector<VertexIds> crease_loops(const TriangleMesh& mesh, const EdgeTable& table, double angle);

}  // namespace sheetmorph::mesh

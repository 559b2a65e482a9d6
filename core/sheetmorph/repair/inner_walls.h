// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/quality/t_junctions.h"

namespace sheetmorph::repair
{

//! The edges of closed pieces that run through a vertex of another piece, in both directions of
//! each edge. Only pieces that share vertices are searched.
//! \param tolerance  mm, >= 0
std::vector<mesh::TJunction> seam_junctions(const mesh::TriangleMesh& mesh, double tolerance);

//! Marks the triangles (m) of flat walls that two pieces share: two flats with the same outline,
//! face to face, whose outline edges both pieces use. Without these walls the pieces form one
//! solid.
std::vector<char> inner_walls(const mesh::TriangleMesh& mesh);

}  // namespace sheetmorph::repair

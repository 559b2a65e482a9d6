// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/quality/t_junctions.h"

namespace sheetmorph::repair
{

//! Where closed pieces of a mesh that have vertices in common lie against each other: the edges of
//! one that run through a vertex of the other, in both directions of each.
//! \param tolerance  mm, >= 0
std::vector<mesh::TJunction> seam_junctions(const mesh::TriangleMesh& mesh, double tolerance);

//! The triangles (m) of flat walls that two pieces have in common: two flats with one outline, face
//! to face, each edge of it used by both. Without them the pieces are one solid.
std::vector<char> inner_walls(const mesh::TriangleMesh& mesh);

}  // namespace sheetmorph::repair

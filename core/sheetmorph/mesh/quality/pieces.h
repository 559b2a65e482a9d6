// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/quality/diagnosis.h"
#include "sheetmorph/mesh/topology/orientation.h"

namespace sheetmorph::mesh
{

//! The triangles of every piece connected through vertices, ordered by first triangle. Triangles
//! that repeat a vertex belong to no piece.
std::vector<std::vector<int>> triangles_of_pieces(const TriangleMesh& mesh, const EdgeTable& table);

//! Diagnoses each piece of a mesh with merged vertices, in the order of triangles_of_pieces().
std::vector<PieceDiagnosis> diagnose_pieces(const TriangleMesh& mesh, const EdgeTable& table);

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/quality/diagnosis.h"
#include "sheetmorph/mesh/topology/orientation.h"

namespace sheetmorph::mesh
{

//! The triangles of every piece connected over vertices, by their first triangle. Triangles that
//! repeat a vertex belong to none.
std::vector<std::vector<int>> triangles_of_pieces(const TriangleMesh& mesh, const EdgeTable& table);

//! What each connected piece of a mesh whose near vertices are one is, in the order of
//! triangles_of_pieces().
std::vector<PieceDiagnosis> diagnose_pieces(const TriangleMesh& mesh, const EdgeTable& table);

}  // namespace sheetmorph::mesh

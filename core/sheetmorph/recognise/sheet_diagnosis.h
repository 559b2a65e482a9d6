// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/quality/diagnosis.h"

namespace sheetmorph::recognise
{

//! The diagnosis of a mesh with its thin solids: the closed pieces that find_thin_solid() finds
//! thin once near vertices are one and every piece faces outwards.
//! \throws InvalidInput as diagnose()
mesh::Diagnosis diagnose_sheets(const mesh::TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::recognise

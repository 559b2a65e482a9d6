// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/quality/diagnosis.h"

namespace sheetmorph
{

//! The diagnosis of a mesh with its thin solids: the closed pieces that find_thin_solid() finds
//! thin once near vertices are one and every piece faces outwards.
//! \throws InvalidInput as diagnose()
Diagnosis diagnose_sheets(const TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph

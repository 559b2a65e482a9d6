// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/quality/diagnosis.h"

namespace sheetmorph::recognise
{

//! Diagnoses a mesh and also marks its thin solids. It merges near vertices, orients every piece
//! outwards and marks the closed pieces that find_thin_solid() recognises as thin.
//! \throws InvalidInput as diagnose()
mesh::Diagnosis diagnose_sheets(const mesh::TriangleMesh& mesh, double tolerance);

}  // namespace sheetmorph::recognise

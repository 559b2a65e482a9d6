// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/cad_model.h"
#include "sheetmorph/cad/meshing/cad_meshing.h"

namespace sheetmorph::cad
{

//! The parts of a STEP, IGES or BREP file, one a solid or free shell, named and placed as in the
//! file, meshed so that faces share the vertices of their common edges.
//! \param path     in UTF-8; the ending tells the format: .step .stp .iges .igs .brep .brp
//! \throws InvalidInput "what; what to do" for sizes out of range, a file that is none of these,
//!         and a file without a face that can be meshed
CadModel read_cad(const std::string& path, const CadMeshing& meshing, const Progress& progress);

//! The same for one shape in OpenCASCADE's BREP format, its parts called `name`, `name 2`, ...
CadModel read_brep(const std::string& text, const std::string& name, const CadMeshing& meshing,
                   const Progress& progress = {});

}  // namespace sheetmorph::cad

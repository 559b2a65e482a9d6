// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/cad_model.h"
#include "sheetmorph/cad/meshing/cad_meshing.h"

namespace sheetmorph::cad
{

//! Reads the parts of a STEP, IGES or BREP file, one per solid or free shell, named and placed as
//! in the file. Faces share the vertices of their common edges.
//! \param path     in UTF-8; its ending gives the format: .step .stp .iges .igs .brep .brp
//! \throws InvalidInput "what; what to do" for sizes out of range, a file of another format, or a
//!     file without a face that can be meshed
CadModel read_cad(const std::string& path, const CadMeshing& meshing, const Progress& progress);

//! The same for one shape in OpenCASCADE's BREP format. Its parts are named `name`, `name 2`, ...
CadModel read_brep(const std::string& text, const std::string& name, const CadMeshing& meshing,
                   const Progress& progress = {});

}  // namespace sheetmorph::cad

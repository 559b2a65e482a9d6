// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_model.h"

namespace sheetmorph::cad
{

//! The mesh of a part and what is known of it, for kept_model: bytes of this machine's numbers.
std::string kept_mesh(const CadPart& part);

//! A model of one part that was kept, without meshing it again: its shape as brep_of() tells it and
//! its mesh as kept_mesh() does. It can be written as CAD; it knows no surfaces.
//! \throws InvalidInput if both do not belong together
CadModel kept_model(const std::string& brep, const std::string& mesh, const std::string& name);

}  // namespace sheetmorph::cad

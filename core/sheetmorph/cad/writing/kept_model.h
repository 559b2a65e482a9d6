// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_model.h"

namespace sheetmorph::cad
{

//! The mesh of a part and its data for kept_model(), in the number format of this machine.
std::string kept_mesh(const CadPart& part);

//! A stored model of one part, without meshing it again: its shape from brep_of() and its mesh from
//! kept_mesh(). It can be written as CAD, but has no surfaces.
//! \throws InvalidInput if the two do not match
CadModel kept_model(const std::string& brep, const std::string& mesh, const std::string& name);

}  // namespace sheetmorph::cad

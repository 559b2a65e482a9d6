// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "answer.h"

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/cad_model.h"

#include <string>
#include <vector>

namespace sheetmorph::cad_worker
{

//! Does what requests ask. It keeps the last model that was read, for the requests that follow.
//!
//! The fields of a request, the first of which names it (sizes: edge, deflection, angle; see
//! CadMeshing; numbers are float64 or int32 of this machine):
//!   read_cad    path, sizes
//!   read_brep   text, name, sizes
//!   kept_model  text, mesh, name
//!   kept_mesh   part
//!   brep        part
//!   write_cad   path, format, tolerances (of surfaces, of edges), then positions of each part
class Requests
{
public:
    //! \throws InvalidInput, SolverError
    Answer answer(const std::vector<std::string>& request, const Progress& progress);

private:
    cad::CadModel model_;
};

}  // namespace sheetmorph::cad_worker

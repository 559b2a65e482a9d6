// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/cad_model.h"
#include "sheetmorph/cad/writing/cad_measures.h"

namespace sheetmorph::cad
{

enum class CadFormat
{
    step,
    iges,
    brep
};

//! How deformed CAD parts are written.
struct CadWriting
{
    std::string path;  //!< in UTF-8, of the file that is made
    CadFormat format = CadFormat::step;
    double tolerance = 0.01;         //!< of a surface from the mesh, mm
    double edge_tolerance = 0.0005;  //!< between an edge and its surfaces, mm
};

//! Writes what was read once more, its shapes carried to where their meshes are: the same assembly,
//! names, colours and layers. Instances of one product that differ now become products of their
//! own; what did not move is written as it was. Then reads the file again and measures it.
//!
//! \param positions  (n, 3) of every part, in the order and with the vertices of model.parts, mm
//! \returns what the file holds, one a part
//! \throws InvalidInput for other positions, a part with faces that were not meshed, a file that
//!         cannot be written; SolverError; Cancelled
std::vector<CadMeasures> write_cad(const CadModel& model, const std::vector<Points>& positions,
                                   const CadWriting& writing, const Progress& progress);

//! The shape of one part in OpenCASCADE's BREP format, where it stands in the assembly, at rest.
//! \throws InvalidInput if the model was not read of a file
std::string brep_of(const CadModel& model, int part);

}  // namespace sheetmorph::cad

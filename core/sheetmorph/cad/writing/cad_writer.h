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

//! Options for writing deformed CAD parts.
struct CadWriting
{
    std::string path;  //!< of the new file, in UTF-8
    CadFormat format = CadFormat::step;
    double tolerance = 0.01;         //!< between a surface and the mesh, mm
    double edge_tolerance = 0.0005;  //!< between an edge and its surfaces, mm
};

//! Writes the file of a model with its shapes carried to their deformed meshes: the same assembly,
//! names, colours and layers. Instances of one product that now differ become separate products.
//! Parts that did not move are written unchanged. Then reads the file again and measures it.
//! \param positions  (n, 3) of every part, in the order and with the vertices of model.parts, mm
//! \returns measures of the file, one per part
//! \throws InvalidInput for other positions, a part with faces that were not meshed, or a file that
//!     cannot be written; SolverError; Cancelled
std::vector<CadMeasures> write_cad(const CadModel& model, const std::vector<Points>& positions,
                                   const CadWriting& writing, const Progress& progress);

//! The shape of one part at rest in OpenCASCADE's BREP format, placed as in the assembly.
//! \throws InvalidInput if the model does not come from a file
std::string brep_of(const CadModel& model, int part);

}  // namespace sheetmorph::cad

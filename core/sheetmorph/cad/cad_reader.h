// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/cad/cad_model.h"

namespace sheetmorph
{

//! How finely CAD parts are meshed. The edges of a curved face follow its curvature, flat faces
//! are filled with triangles that grow from the edges around them.
struct CadMeshing
{
    double edge =
        0.0;  //!< longest edge aimed at, mm; 0: 1/100 of the diagonal of what is in the file
    double deflection = 0.0;  //!< how far an edge may be from the surface, mm; 0: edge / 50
    double angle = 0.35;      //!< how far the surface may turn along an edge, radians, below pi / 2
};

//! The parts of a STEP, IGES or BREP file, one a solid or free shell, named and placed as in the
//! file, meshed so that faces share the vertices of their common edges.
//! \param path     in UTF-8; the ending tells the format: .step .stp .iges .igs .brep .brp
//! \throws InvalidInput "what; what to do" for sizes out of range, a file that is none of these,
//!         and a file without a face that can be meshed
CadModel read_cad(const std::string& path, const CadMeshing& meshing, const Progress& progress);

//! The same for one shape in OpenCASCADE's BREP format, its parts called `name`, `name 2`, ...
CadModel read_brep(const std::string& text, const std::string& name, const CadMeshing& meshing,
                   const Progress& progress = {});

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/cad_meshing.h"
#include "sheetmorph/cad/meshing/stoppable.h"

#include <TopoDS_Shape.hxx>

namespace sheetmorph::cad
{

//! Triangulates every face of a shape with OpenCASCADE's BRepMesh, its edges cut so that no piece
//! is longer than `meshing.edge`; the triangulations are then in the shape.
//! \param meshing  all three sizes > 0
//! \throws Cancelled if the flag is set meanwhile
void triangulate(const TopoDS_Shape& shape, const CadMeshing& meshing,
                 const StopFlag* stop = nullptr);

}  // namespace sheetmorph::cad

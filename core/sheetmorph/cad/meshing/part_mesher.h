// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_model.h"
#include "sheetmorph/cad/meshing/cad_meshing.h"
#include "sheetmorph/cad/meshing/stoppable.h"

#include <TopoDS_Shape.hxx>

namespace sheetmorph::cad
{

//! The mesh of a shape that triangulate() has been through, without a name: faces refined, and
//! welded along their common edges.
//! \param shape    a solid, shell or compound in its own coordinates
//! \param meshing  all three sizes > 0
//! \throws Cancelled if the flag is set meanwhile
CadPart mesh_part(const TopoDS_Shape& shape, const CadMeshing& meshing,
                  const StopFlag* stop = nullptr);

}  // namespace sheetmorph::cad

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/fitting/surface.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! All facets of a mesh; `corners` contains every vertex once.
fitting::FacetSample facets_of(const TriangleMesh& mesh);

}  // namespace sheetmorph::mesh

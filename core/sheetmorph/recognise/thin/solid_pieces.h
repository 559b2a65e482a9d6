// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/inward_probes.h"
#include "sheetmorph/recognise/thin/thin_solid.h"

namespace sheetmorph::recognise
{

//! The vertices of every connected wall, rims included, ordered by first vertex.
std::vector<VertexIds> wall_pieces(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                                   const std::vector<SolidSide>& facets);

//! The walls around holes. Their facets face the middle of the wall; those of an outer border face
//! away from it.
//! \param solid  only facets and vertices are used
std::vector<ThroughHole> through_holes(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                                       const ThinSolid& solid);

//! The vertices of every lump. Lump facets that share a vertex or face each other through the
//! material form one lump.
//! \param is_lump  (m)
std::vector<VertexIds> lump_pieces(const mesh::TriangleMesh& mesh,
                                   const std::vector<InwardProbe>& probes,
                                   const std::vector<char>& is_lump);

}  // namespace sheetmorph::recognise

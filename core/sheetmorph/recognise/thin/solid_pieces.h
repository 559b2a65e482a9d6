// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/inward_probes.h"
#include "sheetmorph/recognise/thin/thin_solid.h"

namespace sheetmorph::recognise
{

//! The vertices of every connected piece of wall, rims included; by rising first vertex.
std::vector<VertexIds> wall_pieces(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                                   const std::vector<SolidSide>& facets);

//! The walls that go around a hole: their facets look at the middle of what they enclose, those of
//! an outer border away from it. \param solid  facets, vertices and walls are read
std::vector<ThroughHole> through_holes(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                                       const ThinSolid& solid);

//! The vertices of every lump; facets on both skins are one if they see each other.
//! \param is_lump  (m)
std::vector<VertexIds> lump_pieces(const mesh::TriangleMesh& mesh,
                                   const std::vector<InwardProbe>& probes,
                                   const std::vector<char>& is_lump);

}  // namespace sheetmorph::recognise

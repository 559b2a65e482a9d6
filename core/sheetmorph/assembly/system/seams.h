// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/system/sheet.h"

namespace sheetmorph::assembly
{

//! A contact between two parts of one sheet that is not rigid, in vertices of the sheet. The source
//! is the coarser side.
struct Seam
{
    std::string name;
    VertexIds target, source;
    std::vector<mesh::Anchor> of_target, of_source;  //!< by vertex: its place on the other side
    int rank = 0, source_rank = 0;                   //!< ranks_by_fineness() of the two parts
};

//! What goes along with rigid shapes across seams: pairs of vertices of which one is rigid, the
//! nearest first, each at most once a seam, so that a chain of pairs never makes a seam rigid.
//! Which side is which, and which part is the primary, does not matter.
//! \param sheet  its features, handles and fixed regions are rigid already
//! \returns      disjoint sets of vertices, named by the first contact that joins them
std::vector<surface::KnownRegion> stitched(const Sheet& sheet, const std::vector<Seam>& seams);

}  // namespace sheetmorph::assembly

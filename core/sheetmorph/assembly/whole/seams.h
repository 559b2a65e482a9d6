// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"

namespace sheetmorph::assembly
{

//! The two sides of a contact that is not rigid, in vertices of the joined part.
struct Seam
{
    std::string name;
    VertexIds a, b;
};

//! What goes along with rigid shapes across seams: pairs of vertices of which one is rigid, the
//! nearest first, each at most once a seam, so that a chain of pairs never makes a seam rigid.
//! Which side is which, and which part is the primary, does not matter.
//! \param joined  of one part: its features, handles and fixed regions are rigid already
//! \returns       disjoint sets of vertices, named by the first contact that joins them
std::vector<PartRegion> stitched(const Assembly& joined, const std::vector<Seam>& seams);

}  // namespace sheetmorph::assembly

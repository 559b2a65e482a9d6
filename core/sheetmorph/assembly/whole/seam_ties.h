// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/propagation_plan.h"
#include "sheetmorph/mesh/search/anchor.h"

namespace sheetmorph::assembly
{

//! By part: its place among all, the coarsest first; as fine ones by name. In contacts finer parts
//! stand on coarser ones, so that which part is the primary, or which side is told first, does not
//! matter.
std::vector<int> ranks_by_fineness(const Assembly& assembly);

//! Lets the coarser part be the source of every contact that is measured.
void lead_by_coarser(const Assembly& assembly, PropagationPlan& plan);

//! Where the two sides of a contact lie on each other: by vertex, nearest_anchors().
struct SeamPlaces
{
    std::vector<mesh::Anchor> of_target, of_source;
};

//! A contact that is not rigid, in vertices of the joined part; the source is the coarser side.
struct TiedSeam
{
    VertexIds target, source;
    SeamPlaces places;
    int rank = 0, source_rank = 0;  //!< of the two parts
};

//! Every vertex of a target stands on the nearest source, but for rigid ones, and corners of the
//! triangles of points. Where it stands on another sheet already, and that not on this one, the
//! source stands on the target.
//! \param joined  of one part, with its stitches
//! \returns       such that the ties of its corners come before a tie
std::vector<surface::Tie> tied(const Assembly& joined, const std::vector<TiedSeam>& seams);

}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/link_plan.h"
#include "sheetmorph/assembly/plan/pair_plan.h"
#include "sheetmorph/assembly/system/sheet.h"
#include "sheetmorph/mesh/search/part_geometry.h"

#include <deque>

namespace sheetmorph::assembly
{

//! What answers a part: rows of one sheet, and those of its bodies and handles that the part is on.
struct Owner
{
    int sheet = 0;
    int first = 0;           //!< the part's first vertex there; the others follow
    int first_triangle = 0;  //!< likewise
    int count = 0;           //!< vertices of the part

    //! The part's features: indices into Assembly::features.
    std::vector<int> features;

    //! Features of the sheet with vertices of the part; first those of `features`.
    std::vector<int> bodies;
    std::vector<int> handles;  //!< handles of the sheet with vertices of the part

    //! Those of a sheet's vertices that are the part's, in its own numbers.
    VertexIds own(const VertexIds& vertices) const;
};

//! What is solved for an assembly, whatever its propagation: sheets, and what passes motion from
//! sheet to sheet. Where parts are answered one after the other each is a sheet. Where they are
//! answered all at once those that are reached are one sheet: what is held anywhere holds, and
//! motion goes both ways. Contacts of one sheet are constraints of it: stacks of rigid ones are
//! form features, others stitches (seams.h) and ties (seam_ties.h).
struct System
{
    PropagationPlan plan;
    std::vector<PlannedLink> links;
    std::vector<RigidWeld> welds;
    std::vector<PlannedPair> pairs;
    std::vector<Sheet> sheets;
    std::vector<Owner> owners;  //!< by part

    std::vector<int> order;                //!< sheets that are reached, the primary's first
    std::vector<std::vector<int>> stages;  //!< the same; none of a stage moves another

    int sheet_of(int part) const { return owners[static_cast<std::size_t>(part)].sheet; }
};

//! What a system is made of.
struct SystemInput
{
    const Assembly& assembly;          //!< thin solids taken down to their middles
    const std::vector<char>& is_thin;  //!< by part
    const std::deque<mesh::PartGeometry>& geometries;
    const ControlBoxes& boxes;
};

//! \throws InvalidInput naming part, region and ids, if what the assembly says contradicts
System plan_system(const SystemInput& input);

}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/skin_cells.h"

namespace sheetmorph::recognise
{

//! Of a thin component's surface.
constexpr double least_share_of_skins = 0.6;

//! Which facets make up the two skins of every thin component.
struct SkinPairs
{
    std::vector<int> side;      //!< (m) +1 and -1 on the two skins, 0 on everything else
    std::vector<char> is_thin;  //!< by component
    std::vector<double> share;  //!< by component: of its surface that the two skins are
};

//! Gathers the cells of every component to two skins: what sees each other through the material is
//! on opposite sides; cells that meet in a crease, or are part of one smooth patch, are one skin if
//! that puts every facet on one side only - so ribs, which would be on both, are none.
//! A component is thin if its skins are at least 60 % of its surface and its thickness is at most a
//! tenth of its size.
//! \param are_several  whether a component may have several sheets, which something that is not
//! thin
//!                     joins, as welded brackets do
SkinPairs skin_pairs(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                     const SkinCells& cells, bool are_several = false);

}  // namespace sheetmorph::recognise

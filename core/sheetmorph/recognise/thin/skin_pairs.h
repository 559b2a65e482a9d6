// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/skin_cells.h"

namespace sheetmorph::recognise
{

//! Minimum share of a thin component's surface. Chosen above a half: a square plate a tenth as
//! thick as its diagonal has 78 %, and bosses may take some of it.
constexpr double least_share_of_skins = 0.6;

//! The facets that form the two skins of every thin component.
struct SkinPairs
{
    std::vector<int> side;      //!< (m) +1 and -1 on the two skins, 0 elsewhere
    std::vector<char> is_thin;  //!< by component
    std::vector<double> share;  //!< by component: share of its surface that the two skins cover
};

//! Groups the cells of every component into two skins. Cells that face each other through the
//! material are on opposite sides. Cells that meet in a crease, or belong to one smooth patch, join
//! the same skin if every facet then has a unique side. Ribs would be on both sides and are
//! excluded.
//! A component is thin if its skins cover at least 60 % of its surface and its thickness is at most
//! a tenth of its size.
//! \param are_several  whether a component may have several sheets joined by a thick body, as
//!                     welded brackets have
SkinPairs skin_pairs(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                     const SkinCells& cells, bool are_several = false);

}  // namespace sheetmorph::recognise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/skin_pairs.h"

namespace sheetmorph::recognise
{

//! What every facet of the thin components is, once nothing is left open.
struct FacetSides
{
    std::vector<int> side;      //!< (m) +1 and -1 on the skins; 0 on walls, on lumps off the skins
                                //!< and on components that are not thin
    std::vector<char> is_lump;  //!< (m) where the material is not thin
    std::vector<char> is_step;  //!< (m) the rim of an embossed or engraved shape on a skin
};

//! Gives the facets that are on neither skin to a skin, to the walls or to the lumps.
//! - Part of a smooth patch of one skin (the foot of a boss seen from behind, the strip along a
//!   sharp fold): on that skin, unless it looks along the other one, as a rounded wall does.
//! - Otherwise, within 1.6 thicknesses of both skins: a wall; but a wall with the same skin on all
//!   its sides (the rim of an embossed letter, a ledge up to the border) belongs to that skin.
//! - Everything else is a lump, and so are facets of a skin that are farther than 1.8 thicknesses
//!   from the other.
FacetSides skin_walls(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                      const SkinCells& cells, const SkinPairs& pairs);

}  // namespace sheetmorph::recognise

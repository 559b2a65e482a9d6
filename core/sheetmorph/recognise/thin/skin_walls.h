// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/skin_pairs.h"

namespace sheetmorph::recognise
{

//! The classification of every facet of the thin components.
struct FacetSides
{
    //! (m) +1 and -1 on the skins; 0 on walls, on lumps off the skins and on components that are
    //! not thin
    std::vector<int> side;
    std::vector<char> is_lump;  //!< (m) where the material is not thin
    std::vector<char> is_step;  //!< (m) rim of an embossed or engraved shape on a skin
};

//! Assigns the facets that are on neither skin to a skin, a wall or a lump.
//! - A facet in a smooth patch of one skin joins that skin. Examples are the foot of a boss seen
//!   from behind and the strip along a sharp fold. A rounded wall is an exception: its facets run
//!   along the direction to the other skin.
//! - Any other facet within 1.6 thicknesses of both skins is a wall. A wall bordered by the same
//!   skin on all sides (the rim of an embossed letter, a ledge up to the border) joins that skin.
//! - All other facets are lumps, and so are facets of a skin farther than 1.8 thicknesses from the
//!   other skin.
FacetSides skin_walls(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                      const SkinCells& cells, const SkinPairs& pairs);

}  // namespace sheetmorph::recognise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sheetmorph/base/types.h"

namespace sheetmorph::coin
{

//! How a set of vertices is drawn; faces and lines are each closed by -1, as Coin wants them.
struct PatchPieces
{
    std::vector<std::int32_t> faces;   //!< facets with all their vertices in the set
    std::vector<std::int32_t> lines;   //!< edges within the set at which at most one facet is drawn
    std::vector<std::int32_t> points;  //!< the vertices that are left, ascending
};

//! \param triangles  (m, 3); those without any of the vertices may be left out
//! \param vertices   in any order, repeated or not
//! \throws std::invalid_argument for a negative index
PatchPieces patch_pieces(const Eigen::Ref<const Triangles>& triangles,
                         const Eigen::Ref<const Eigen::VectorXi>& vertices);

//! Addresses of the nodes of a patch as pivy gives them: int(node.this).
struct PatchAddresses
{
    std::uintptr_t faces = 0;   //!< SoIndexedFaceSet
    std::uintptr_t lines = 0;   //!< SoIndexedLineSet
    std::uintptr_t points = 0;  //!< SoIndexedPointSet
};

//! Shows the pieces in the nodes; returns whether there are any.
//! \throws std::invalid_argument if an address is no node of its type
bool show_patch(const PatchAddresses& nodes, const PatchPieces& pieces);

}  // namespace sheetmorph::coin

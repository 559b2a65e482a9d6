// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/contacts/part_shape.h"

#include <array>

namespace sheetmorph::recognise
{

//! Touching vertices of two parts that hang together.
struct Patch
{
    std::array<VertexIds, 2> sides;  //!< of the welded meshes, ascending
    double distance = 0.0;           //!< median, mm
    double edge_share = 0.0;         //!< of the touches that are free edges only
};

//! The patches of a pair: vertices belong together along edges of their part,
//! over a vertex between them that is a few times `reach` (mm, that of the
//! touches) away, and across both parts by the triangle they touch. A side of fewer than three
//! vertices takes in the corners of the triangles that the other side touches.
//! By smallest vertex.
std::vector<Patch> patches_of(const PartShape& a, const PartShape& b,
                              const std::array<std::vector<Touch>, 2>& touches, double reach);

}  // namespace sheetmorph::recognise

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/contacts/part_shape.h"

#include <array>

namespace sheetmorph::recognise
{

//! A cluster of touching vertices of two parts.
struct Patch
{
    std::array<VertexIds, 2> sides;  //!< vertices of the merged meshes, ascending
    double distance = 0.0;           //!< median distance, mm
    double edge_share = 0.0;         //!< share of the touches that only free edges make
};

//! Clusters the touching vertices of two parts into patches, ordered by their first vertex. Two
//! vertices of a part join if they share a triangle, or if both share one with a vertex within
//! three times `reach` of the other part. Vertices of different parts join if one is a corner of
//! the triangle that the other touches. A side with fewer than three vertices also takes the
//! corners of the triangles that the other side touches.
//! \param reach  the contact distance used for `touches`, mm
std::vector<Patch> patches_of(const PartShape& a, const PartShape& b,
                              const std::array<std::vector<Touch>, 2>& touches, double reach);

}  // namespace sheetmorph::recognise

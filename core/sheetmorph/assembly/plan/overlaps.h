// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/assembly/pose.h"

namespace sheetmorph::assembly
{

//! The vertices that a fixed region and a handle share.
struct Overlap
{
    int fixed = 0;   //!< index into Assembly::fixed
    int handle = 0;  //!< index into Assembly::handles
    VertexIds vertices;
};

std::vector<Overlap> overlaps_of(const Assembly& assembly);

//! A handle may rotate about fixed vertices, but must not move them.
//! \throws InvalidInput naming both regions and the vertices that the pose moves beyond exactness
void check_overlaps(const Assembly& assembly, const std::vector<Overlap>& overlaps,
                    const Pose& pose);

}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"

namespace sheetmorph
{

//! How thick a closed body is, looked at from samples spread evenly over its area.
struct WallThickness
{
    double median = 0.0;  //!< to the opposite facet through the body, mm; 0 if nothing is opposite
    double low = 0.0;     //!< of nine tenths of the samples near the median, the least, mm
    double high = 0.0;    //!< the greatest of them, mm
    double share = 0.0;   //!< of the area: where it is within half the median of the median
};

//! Looks into a body, at right angles, from up to `samples` places on its triangles.
//! \param tree  over the mesh, or over more than the body
//! \param sign  (m) +1 where a triangle faces outwards as it stands, else -1
WallThickness wall_thickness(const TriangleMesh& mesh, const PickingTree& tree,
                             const std::vector<int>& triangles, const std::vector<int>& sign);

}  // namespace sheetmorph

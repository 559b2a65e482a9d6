// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::coin
{

//! Which normal each corner of each triangle is drawn with; corners share one across smooth edges.
struct CornerNormals
{
    Triangles of_corner;  //!< (m, 3) rows of the array of normals
    int count = 0;        //!< number of normals
};

//! \param points     (n, 3) mm at rest
//! \param triangles  (m, 3)
//! \param crease     radians; across an edge that turns by more the shading breaks
CornerNormals corner_normals(const Points& points, const Triangles& triangles, double crease);

}  // namespace sheetmorph::coin

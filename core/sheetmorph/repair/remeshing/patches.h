// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::repair
{

//! The flat and curved regions of a mesh and the ridges between them.
struct Patches
{
    std::vector<int> plane;      //!< (m) index of the triangle's coplanar group
    std::vector<int> patch;      //!< (m) index of the triangle's patch: a flat or a curved region
    std::vector<char> is_flat;   //!< by patch
    std::vector<char> is_ridge;  //!< by edge of the table: whether it is the border of a patch
};

//! Options of find_patches().
struct PatchOptions
{
    double crease_angle = 0.35;  //!< edges with a larger bend are ridges, radians
    double least_width = 1.0;    //!< coplanar groups wider than this are flats, mm
};

//! Splits a mesh into patches. Facets are coplanar within 2e-7 of the size of the mesh.
Patches find_patches(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                     const PatchOptions& options);

}  // namespace sheetmorph::repair

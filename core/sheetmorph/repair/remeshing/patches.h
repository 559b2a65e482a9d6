// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::repair
{

//! Where a mesh is flat, where it is curved, and where it breaks.
struct Patches
{
    std::vector<int> plane;      //!< (m) which coplanar group of facets a triangle belongs to
    std::vector<int> patch;      //!< (m) which patch it belongs to: a flat, or a curved region
    std::vector<char> is_flat;   //!< of every patch
    std::vector<char> is_ridge;  //!< of every edge of the table: the border of a patch
};

//! What splits a mesh into patches.
struct PatchOptions
{
    double crease_angle = 0.35;  //!< edges that bend by more are ridges, radians
    double least_width = 1.0;    //!< coplanar groups wider than this are flats of their own, mm
};

//! The patches of a mesh. Facets are coplanar within 2e-7 of the size of the mesh.
Patches find_patches(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                     const PatchOptions& options);

}  // namespace sheetmorph::repair

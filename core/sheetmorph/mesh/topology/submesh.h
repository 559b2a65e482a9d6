// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! Some triangles of a mesh with the vertices they use.
struct Submesh
{
    TriangleMesh mesh;   //!< triangles in the order they were given
    VertexIds vertices;  //!< (k) of the whole mesh, ascending
    VertexIds index_of;  //!< (n) of every vertex of the whole mesh in `mesh`; -1 if it is not there
};

//! \param triangles  rows of the mesh's triangles, each in range
Submesh submesh(const TriangleMesh& mesh, const std::vector<int>& triangles);

}  // namespace sheetmorph::mesh

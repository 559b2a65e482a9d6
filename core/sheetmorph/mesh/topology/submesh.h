// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! A subset of the triangles of a mesh with the vertices they use.
struct Submesh
{
    TriangleMesh mesh;   //!< triangles in the given order
    VertexIds vertices;  //!< (k) vertices of the whole mesh, ascending
    VertexIds index_of;  //!< (n) by vertex of the whole mesh: its index in `mesh`, or -1
};

//! \param triangles  rows of the mesh's triangles, each in range
Submesh submesh(const TriangleMesh& mesh, const std::vector<int>& triangles);

}  // namespace sheetmorph::mesh

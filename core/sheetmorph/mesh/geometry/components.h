// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! Which connected component each vertex belongs to.
struct Components
{
    std::vector<int> label;  //!< (n) 0.. in order of first appearance; unused for lone vertices
    int count = 0;

    static constexpr int unused = -1;

    //! The vertices of one component, ascending.
    VertexIds vertices(int component) const;
};

//! Components of a mesh by shared vertices. A vertex is unused if no triangle with three different
//! vertices and some extent has it. Each of `joined` makes one component of all its vertices,
//! unused ones included unless all are.
Components connected_components(const TriangleMesh& mesh,
                                const std::vector<VertexIds>& joined = {});

}  // namespace sheetmorph::mesh

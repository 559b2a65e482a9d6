// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! The connected component of each vertex.
struct Components
{
    std::vector<int> label;  //!< (n) from 0 in order of first appearance; `unused` without one
    int count = 0;

    static constexpr int unused = -1;

    //! The vertices of one component, ascending.
    VertexIds vertices(int component) const;
};

//! Components of a mesh by shared vertices. A vertex is unused if no non-degenerate triangle
//! contains it. Each group in `joined` connects all its vertices. Unused vertices of a group join
//! its component, unless the whole group is unused.
Components connected_components(const TriangleMesh& mesh,
                                const std::vector<VertexIds>& joined = {});

}  // namespace sheetmorph::mesh

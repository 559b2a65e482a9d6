// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/vertex_triangles.h"
#include "sheetmorph/recognise/facets/facet_graph.h"

namespace sheetmorph::recognise
{

//! Grows rings of triangles around a few vertices of a large mesh.
class WasherGrower
{
public:
    explicit WasherGrower(const FacetGraph& graph) : graph_(graph), triangles_(graph.mesh()) {}

    //! Ring k contains the vertices, ascending, that share a triangle with ring k - 1 and are in no
    //! earlier ring. Ring 0 is `vertices` and is not returned.
    std::vector<VertexIds> rings(const VertexIds& vertices, int count) const;

private:
    const FacetGraph& graph_;
    mesh::VertexTriangles triangles_;
};

}  // namespace sheetmorph::recognise

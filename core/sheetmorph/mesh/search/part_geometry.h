// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/submesh.h"
#include "sheetmorph/mesh/topology/vertex_triangles.h"

#include <mutex>
#include <optional>

namespace sheetmorph::mesh
{

//! What all who read one mesh share: each worked out once, when it is first asked for, by any
//! thread. What is only needed around some vertices - areas, normals, rings - is taken of patch().
class PartGeometry
{
public:
    //! \param mesh  outlives it
    explicit PartGeometry(const TriangleMesh& mesh) : mesh_(mesh) {}
    PartGeometry(const PartGeometry&) = delete;
    PartGeometry& operator=(const PartGeometry&) = delete;

    const TriangleMesh& mesh() const { return mesh_; }
    const VertexTriangles& triangles() const;
    const PickingTree& tree() const;

    //! All triangles that have at least one of the vertices: their rings are whole.
    Submesh patch(const VertexIds& vertices) const;

private:
    const TriangleMesh& mesh_;
    mutable std::once_flag triangles_are_there_, tree_is_there_;
    mutable std::optional<VertexTriangles> triangles_;
    mutable std::optional<PickingTree> tree_;
};

}  // namespace sheetmorph::mesh

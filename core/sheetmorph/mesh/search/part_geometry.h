// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/submesh.h"
#include "sheetmorph/mesh/topology/vertex_triangles.h"

#include <mutex>
#include <optional>

namespace sheetmorph::mesh
{

//! Geometry that all readers of one mesh share. Each item is computed on first use, by any thread.
//! For areas, normals and rings around a few vertices, use patch().
class PartGeometry
{
public:
    //! \param mesh  must outlive this object
    explicit PartGeometry(const TriangleMesh& mesh) : mesh_(mesh) {}
    PartGeometry(const PartGeometry&) = delete;
    PartGeometry& operator=(const PartGeometry&) = delete;

    const TriangleMesh& mesh() const { return mesh_; }
    const VertexTriangles& triangles() const;
    const PickingTree& tree() const;

    //! All triangles that contain at least one of the vertices, so that their rings are complete.
    Submesh patch(const VertexIds& vertices) const;

private:
    const TriangleMesh& mesh_;
    mutable std::once_flag triangles_are_there_, tree_is_there_;
    mutable std::optional<VertexTriangles> triangles_;
    mutable std::optional<PickingTree> tree_;
};

}  // namespace sheetmorph::mesh

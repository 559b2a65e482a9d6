// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/search/part_geometry.h"

namespace sheetmorph::mesh
{

const VertexTriangles& PartGeometry::triangles() const
{
    std::call_once(triangles_are_there_, [this] { triangles_.emplace(mesh_); });
    return *triangles_;
}

const PickingTree& PartGeometry::tree() const
{
    std::call_once(tree_is_there_, [this] { tree_.emplace(mesh_); });
    return *tree_;
}

Submesh PartGeometry::patch(const VertexIds& vertices) const
{
    return submesh(mesh_, triangles().around(vertices));
}

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/pick/screen.h"

namespace sheetmorph::pick
{

//! The vertices, used by a triangle, whose picture lies inside an outline; also those that are
//! hidden. Ascending. The cost is that of what lies in the outline's bounding rectangle.
VertexIds vertices_inside(const mesh::PickingTree& tree, const Screen& screen,
                          const ScreenOutline& outline);

//! Those of `vertices`, of the shape in `tree`, that no triangle of any of the `shapes` hides:
//! none lies in front of the vertex by more than a millionth of the half depth of the view.
//! Triangles seen edge-on, or not wholly in front of the eye, hide nothing. Ascending, once each.
//! \throws InvalidInput naming vertices that do not exist
VertexIds visible_vertices(const mesh::PickingTree& tree, const VertexIds& vertices,
                           const Screen& screen,
                           const std::vector<const mesh::PickingTree*>& shapes);

}  // namespace sheetmorph::pick

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/pick/screen.h"

namespace sheetmorph::pick
{

//! The vertices of triangles whose image lies inside an outline, hidden ones included; ascending.
//! The cost depends only on the part of the shape in the outline's bounding rectangle.
VertexIds vertices_inside(const mesh::PickingTree& tree, const Screen& screen,
                          const ScreenOutline& outline);

//! The vertices, out of `vertices` of the shape in `tree`, that no triangle of any shape hides. A
//! triangle hides a vertex if it lies in front of it by more than a millionth of half the depth of
//! the view. Triangles seen edge-on, or not entirely in front of the eye, hide nothing.
//! \returns ascending ids without repetitions
//! \throws InvalidInput naming vertices that do not exist
VertexIds visible_vertices(const mesh::PickingTree& tree, const VertexIds& vertices,
                           const Screen& screen,
                           const std::vector<const mesh::PickingTree*>& shapes);

}  // namespace sheetmorph::pick

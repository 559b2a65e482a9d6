// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"

namespace sheetmorph::benchmarks
{

//! A curved open sheet with 20 round holes as form features, a fixed strip on its left and a
//! handle of about 1 % of its vertices on its right.
struct Panel
{
    mesh::TriangleMesh mesh;
    surface::SurfaceConstraints constraints;
};

//! \param vertices  about how many; edges are 10 mm long at any number
Panel curved_panel(int vertices);

}  // namespace sheetmorph::benchmarks

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/recognise/feature.h"
#include "sheetmorph/recognise/tolerances.h"

namespace sheetmorph::recognise
{

//! Everything that is found on one part, holes first, then by kind and smallest
//! vertex. Vertices count as the mesh does; where an import has several
//! vertices at one place all of them are in. The same mesh gives the same
//! answer, bit by bit. \throws InvalidInput naming a tolerance out of its range
std::vector<Feature> find_features(const mesh::TriangleMesh& mesh,
                                   const FeatureTolerances& tolerances = {});

}  // namespace sheetmorph::recognise

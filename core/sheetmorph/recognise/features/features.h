// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/recognise/feature.h"
#include "sheetmorph/recognise/tolerances.h"

namespace sheetmorph::recognise
{

//! Finds all features of a part, ordered by kind (holes first) and smallest vertex. Vertices refer
//! to the given mesh; where an import has several coincident vertices, all of them are included.
//! Results are reproducible bit by bit.
//! \throws InvalidInput naming a tolerance that is out of range
std::vector<Feature> find_features(const mesh::TriangleMesh& mesh,
                                   const FeatureTolerances& tolerances = {});

}  // namespace sheetmorph::recognise

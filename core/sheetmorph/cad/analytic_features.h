// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_model.h"

namespace sheetmorph::cad
{

//! The holes, cylinders, planes, cones and spheres of a part, from the surfaces of its faces. Holes
//! come first, then the others, ordered by smallest vertex. Faces that continue each other form one
//! feature.
std::vector<CadFeature> analytic_features(const CadPart& part);

}  // namespace sheetmorph::cad

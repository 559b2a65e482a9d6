// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_model.h"

namespace sheetmorph::cad
{

//! The holes, cylinders, planes, cones and spheres of a part, taken from the surfaces of its faces:
//! holes first, then by rising smallest vertex. Faces that continue each other are one feature.
std::vector<CadFeature> analytic_features(const CadPart& part);

}  // namespace sheetmorph::cad

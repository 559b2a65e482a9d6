// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "answer.h"

#include "sheetmorph/cad/cad_model.h"
#include "sheetmorph/cad/writing/cad_measures.h"

#include <vector>

namespace sheetmorph::cad_worker
{

//! All that a model knows without OpenCASCADE, the exact features of its parts included.
Answer model_answer(const cad::CadModel& model);

//! What was measured in a written file, one object a part.
Answer measures_answer(const std::vector<cad::CadMeasures>& measures);

}  // namespace sheetmorph::cad_worker

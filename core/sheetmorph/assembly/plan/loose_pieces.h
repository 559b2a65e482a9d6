// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/part_problem.h"

namespace sheetmorph::assembly
{

//! Decides pieces of a part that nothing holds while others move, as the assembly wants it, and
//! keeps them in problem.loose. Comes after all other constraints of the part.
//! \throws InvalidInput naming the part, if its constraints contradict
void hold_loose_pieces(const Part& part, Unheld unheld, PartProblem& problem);

}  // namespace sheetmorph::assembly

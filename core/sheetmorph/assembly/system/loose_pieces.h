// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/system/sheet.h"

namespace sheetmorph::assembly
{

//! Decides pieces of a sheet that nothing holds while others move, as the assembly wants it, and
//! keeps them in sheet.loose. Comes after all other constraints of the sheet.
//! \throws InvalidInput naming the sheet's parts, if its constraints contradict
void hold_loose_pieces(Unheld unheld, Sheet& sheet);

}  // namespace sheetmorph::assembly

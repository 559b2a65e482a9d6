// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph::cad
{

//! The worst value of a quantity, and where it occurs.
struct WorstAt
{
    double value = 0.0;
    int face = -1;                    //!< counted from 0; -1 for none
    Vector3 place = Vector3::Zero();  //!< mm
};

}  // namespace sheetmorph::cad

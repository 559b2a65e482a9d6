// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/assembly/pose.h"

namespace sheetmorph::assembly
{

//! \throws InvalidInput naming what the pose gives but the assembly does not have or cannot take
void check_pose_names(const Assembly& assembly, const Pose& pose);

}  // namespace sheetmorph::assembly

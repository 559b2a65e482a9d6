// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/prepared_assembly.h"

namespace sheetmorph::assembly
{

//! DeformationSession::rates(): from part to part, as the pose itself goes.
//! \param pose  told_pose()
std::vector<std::vector<Points>> wave_rates(const PreparedAssembly& prepared, const Pose& pose,
                                            const std::vector<PoseRate>& directions);

}  // namespace sheetmorph::assembly

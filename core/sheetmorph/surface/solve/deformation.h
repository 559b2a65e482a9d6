// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/rigid_motion.h"

#include <vector>

namespace sheetmorph::surface
{

//! A part in one pose.
struct Deformation
{
    Points positions;                   //!< (n, 3) mm
    Points rotation_logs;               //!< (n, 3) radians (2.6)
    std::vector<RigidMotion> features;  //!< of every form feature, about its rest centroid
    Convergence convergence = {};       //!< of what was solved in rounds
    bool is_preview = false;            //!< live, and an exact answer is refined besides
};

}  // namespace sheetmorph::surface

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
    std::vector<RigidMotion> features;  //!< by form feature, about its rest centroid
    Convergence convergence = {};       //!< of the iterative parts of the solution
    bool is_preview = false;            //!< live frame of an energy whose exact result differs
};

}  // namespace sheetmorph::surface

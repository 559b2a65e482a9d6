// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rates.h"
#include "sheetmorph/surface/constraints/targets.h"

namespace sheetmorph::surface
{

//! How the target of a propagated region changes.
struct PropagatedRate
{
    Points positions;      //!< (k, 3) mm
    Points rotation_logs;  //!< (k, 3) radians
    Points spins;          //!< (k, 3) of the rotations
};

//! How SurfaceTargets change along one direction of the pose; in their order, all of them there.
struct TargetRates
{
    std::vector<MotionRate> handles;
    std::vector<Vector3> feature_logs;
    std::vector<double> sizes;  //!< mm, of every form feature
    std::vector<PointTarget> points;
    std::vector<PropagatedRate> propagated;
};

//! How a Deformation changes.
struct DeformationRate
{
    Points positions;      //!< (n, 3) mm
    Points rotation_logs;  //!< (n, 3) radians
    std::vector<MotionRate> features;
};

}  // namespace sheetmorph::surface

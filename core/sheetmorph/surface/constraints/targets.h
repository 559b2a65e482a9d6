// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"

#include <optional>
#include <vector>

namespace sheetmorph::surface
{

//! Target position of one point, and its rotation if that is prescribed.
struct PointTarget
{
    Vector3 position = Vector3::Zero();      //!< mm
    Vector3 rotation_log = Vector3::Zero();  //!< radians (2.6)
};

//! Targets of the vertices of one propagated region, from other parts.
struct PropagatedTarget
{
    Points positions;      //!< (k, 3) mm
    Points rotation_logs;  //!< (k, 3) radians (2.6)

    //! k rotations, if they contain more than their logs (log_near()); empty: those of the logs.
    std::vector<Matrix3> rotations;
};

//! A pose of one part, in the order of its SurfaceConstraints.
struct SurfaceTargets
{
    std::vector<RigidMotion> handles = {};
    std::vector<Vector3> feature_logs = {};         //!< only for prescribed features
    std::vector<std::optional<double>> sizes = {};  //!< by form feature, mm; empty: no size is set
    std::vector<RigidMotion> leaders = {};          //!< by link, only where the leader is -1
    std::vector<PointTarget> points = {};
    std::vector<PropagatedTarget> propagated = {};
};

}  // namespace sheetmorph::surface

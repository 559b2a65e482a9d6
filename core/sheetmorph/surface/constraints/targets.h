// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"

#include <optional>
#include <vector>

namespace sheetmorph::surface
{

//! Where a pose puts one point, and how it turns it if the point is turned.
struct PointTarget
{
    Vector3 position = Vector3::Zero();      //!< mm
    Vector3 rotation_log = Vector3::Zero();  //!< radians (2.6)
};

//! Where other parts put the vertices of one propagated region.
struct PropagatedTarget
{
    Points positions;      //!< (k, 3) mm
    Points rotation_logs;  //!< (k, 3) radians (2.6)

    //! k rotations where they are more than their logs can tell (log_near()); empty: those of the
    //! logs.
    std::vector<Matrix3> rotations;
};

//! A pose of one part, in the order of its SurfaceConstraints.
struct SurfaceTargets
{
    std::vector<RigidMotion> handles = {};
    std::vector<Vector3> feature_logs = {};  //!< read for prescribed features only
    std::vector<std::optional<double>> sizes =
        {};                                 //!< mm, of every form feature; empty: none is set
    std::vector<RigidMotion> leaders = {};  //!< of every link, read where the leader is -1
    std::vector<PointTarget> points = {};
    std::vector<PropagatedTarget> propagated = {};
};

}  // namespace sheetmorph::surface

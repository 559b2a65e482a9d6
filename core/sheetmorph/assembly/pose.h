// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/constraints/targets.h"

#include <map>
#include <string>

namespace sheetmorph::assembly
{

//! The few numbers that decide every shape: what a document stores and a drag changes.
struct Pose
{
    std::map<std::string, RigidMotion> handles;   //!< no motion where left out
    std::map<std::string, Vector3> feature_logs;  //!< of prescribed features (2.6); none left out
    std::map<std::string, surface::PointTarget> points;  //!< every point needs one
    std::map<std::string, double> sizes;                 //!< mm, of resizable features
};

//! How a drag prepares its frames.
struct DragOptions
{
    //! Vertices of the assembly from which parts behind contacts learn how they answer: smaller
    //! ones are substituted in less time than their answers take to put together.
    int least_to_learn = 20000;

    //! Reported to by the background thread; what it throws ends the learning, as any error there.
    Progress progress = {};
};

}  // namespace sheetmorph::assembly

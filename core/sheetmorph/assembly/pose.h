// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"
#include "sheetmorph/surface/constraints/targets.h"

#include <map>
#include <string>

namespace sheetmorph::assembly
{

//! The few numbers that determine every shape. A document stores them, and a drag changes them.
struct Pose
{
    std::map<std::string, RigidMotion> handles;          //!< no motion if missing
    std::map<std::string, Vector3> feature_logs;         //!< of prescribed features (2.6)
    std::map<std::string, surface::PointTarget> points;  //!< every point needs a target
    std::map<std::string, double> sizes;                 //!< mm, of resizable features
};

//! Options for preparing the frames of a drag.
struct DragOptions
{
    //! Fewest vertices of the assembly for which parts behind contacts are sampled. Chosen: for
    //! fewer, back-substitution is faster than combining responses.
    int least_to_learn = 20000;

    //! The background thread reports to it. An exception ends the sampling, like any error there.
    Progress progress = {};
};

}  // namespace sheetmorph::assembly

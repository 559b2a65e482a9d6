// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/deformation_session.h"

#include <ostream>

namespace sheetmorph::assembly::frames
{

//! An assembly with one pose.
struct Frame
{
    std::string name;
    Assembly assembly;
    Pose pose;
};

inline std::ostream& operator<<(std::ostream& out, const Frame& frame)
{
    return out << frame.name;
}

}  // namespace sheetmorph::assembly::frames

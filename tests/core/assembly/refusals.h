// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/errors.h"
#include "assembly/frame.h"

namespace sheetmorph::assembly
{

//! What a session says about an assembly or a pose that it refuses; empty if it takes both.
inline std::string refusal(const frames::Frame& frame)
{
    try
    {
        DeformationSession(frame.assembly).deform(frame.pose);
    }
    catch (const InvalidInput& fault)
    {
        return fault.what();
    }
    return "";
}

}  // namespace sheetmorph::assembly

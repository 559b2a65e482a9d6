// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/system/sheet.h"
#include "sheetmorph/volume/volume_link.h"

namespace sheetmorph::assembly
{

//! What the earlier sheets of the order have become.
struct EarlierSheets
{
    const std::vector<volume::LinkedTargets>& links;  //!< by link; empty if not reached yet
    const std::vector<RigidMotion>& welds;            //!< by weld: motion of its body
    const std::vector<RigidMotion>& features;         //!< of the assembly: about its rest centroid
};

//! The pose of one sheet, with what earlier ones bring.
//! \throws InvalidInput if a point has no target
surface::SurfaceTargets targets_of_sheet(const Assembly& assembly, const Sheet& sheet,
                                         const Pose& pose, const EarlierSheets& earlier);

//! How far apart, at most, several links would put one vertex of the sheet, mm.
double spread_of_targets(const Sheet& sheet, const EarlierSheets& earlier);

}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"

namespace sheetmorph::assembly
{

//! The constraints of one part, and which of the assembly's lists each came from.
struct PartConstraints
{
    surface::SurfaceConstraints surface;
    std::vector<int> handles;   //!< index into Assembly::handles, in the order of surface.handles
    std::vector<int> features;  //!< index into Assembly::features
    std::vector<int> points;    //!< index into Assembly::points
    std::vector<int> leaders;   //!< by link: the leading feature if on another part, else -1

    //! Whether a pose can move the part.
    bool is_driven() const;
};

//! Collects what an assembly says about one part; groups too, but not the pairs of features, whose
//! leaders the propagation order decides.
PartConstraints constraints_of_part(const Assembly& assembly, int part);

//! Where a feature of the assembly stands among those of its part.
int local_feature(const PartConstraints& constraints, int feature);

//! The pose of one part; handles left out do not move, prescribed rotations left out are none,
//! sizes left out are the description's.
//! \throws InvalidInput if a point has no target
surface::SurfaceTargets targets_of_part(const Assembly& assembly,
                                        const PartConstraints& constraints, const Pose& pose);

//! \throws InvalidInput naming what the pose tells but the assembly does not have or cannot be told
void check_pose_names(const Assembly& assembly, const Pose& pose);

}  // namespace sheetmorph::assembly

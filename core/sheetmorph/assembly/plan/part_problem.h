// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/link_plan.h"
#include "sheetmorph/assembly/plan/pair_plan.h"
#include "sheetmorph/assembly/plan/part_pose.h"
#include "sheetmorph/surface/surface_deformer.h"
#include "sheetmorph/volume/volume_link.h"

namespace sheetmorph::assembly
{

//! One row of what a link makes of its targets.
struct LinkRow
{
    int link = 0;
    Eigen::Index row = 0;
    double weight = 1.0;
};

//! Everything that decides one part: its own regions, features and points, the rigid welds it
//! shares, and what links bring.
struct PartProblem
{
    PartConstraints own;        //!< own.surface holds the welds and links too
    std::vector<int> carried;   //!< welds that move this part: handles after the own ones
    std::vector<int> carriers;  //!< welds this part moves others by: features after the own ones
    std::vector<int> held;      //!< welds that a fixed region of some part holds: fixed here too

    std::vector<VertexIds>
        loose;  //!< pieces that nothing else holds: fixed, or features at the end

    //! By propagated region and vertex: the rows whose weighted mean is its target. On one vertex
    //! tied comes before control mesh; of equal rank all count.
    std::vector<std::vector<std::vector<LinkRow>>> propagated;

    bool is_driven() const { return own.is_driven(); }
};

//! What passes motion from part to part, of the whole assembly.
struct Passages
{
    const std::vector<PlannedLink>& links;
    const std::vector<RigidWeld>& welds;
    const std::vector<PlannedPair>& pairs;
};

PartProblem problem_of_part(const Assembly& assembly, int part, const Passages& passages);

//! The same of a part that is solved together with the others: its own share, and every weld on it
//! as a feature.
PartProblem problem_in_whole(const Assembly& assembly, int part,
                             const std::vector<RigidWeld>& welds);

//! What the earlier parts of the order have become.
struct EarlierParts
{
    const std::vector<volume::LinkedTargets>& links;  //!< by link; empty if not reached yet
    const std::vector<RigidMotion>& welds;            //!< by weld: motion of its body
    const std::vector<RigidMotion>& features;         //!< of the assembly: about its rest centroid
};

//! The pose of one part, with what earlier parts bring.
surface::SurfaceTargets targets_in_order(const Assembly& assembly, const PartProblem& problem,
                                         const Pose& pose, const EarlierParts& earlier);

//! How far apart, at most, several links would put one vertex of the part, mm.
double spread_of_targets(const PartProblem& problem, const EarlierParts& earlier);

}  // namespace sheetmorph::assembly

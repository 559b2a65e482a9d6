// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/feature_sizes.h"
#include "sheetmorph/assembly/plan/overlaps.h"
#include "sheetmorph/assembly/plan/part_problem.h"
#include "sheetmorph/assembly/session/deformation_session.h"
#include "sheetmorph/assembly/session/feature_error.h"
#include "sheetmorph/assembly/symmetry/symmetry_plan.h"
#include "sheetmorph/assembly/thin/thin_solver.h"
#include "sheetmorph/assembly/whole/joined_parts.h"

#include <set>

namespace sheetmorph::assembly
{

//! A link and what it was built from, so that a later session can tell whether it still fits.
struct PreparedLink
{
    ContactType type = ContactType::control_mesh;
    VertexIds source;
    Points targets;
    ControlMeshOptions options;
    std::shared_ptr<const MotionLink> link;
};

//! One part, ready to be solved; no deformer if nothing moves it, or if it is solved with others.
struct PreparedPart
{
    PartProblem problem;
    std::vector<FeatureEdges> edges;
    std::shared_ptr<const surface::SurfaceDeformer> deformer;
    std::shared_ptr<const ThinSolver> thin;  //!< from its middle to the whole of a thin solid
};

//! Everything a session knows before a pose.
struct PreparedAssembly
{
    Assembly assembly;  //!< what is solved: completed where it has a plane of symmetry, thin
                        //!< parts taken down to their middles
    std::optional<Assembly> with_thin_parts;  //!< with all of thin parts, and their lumps
    ThinParts thin;
    std::optional<SymmetryPlan> symmetry;
    std::vector<std::optional<forms::FeatureShape>> shapes;  //!< by feature, of sized ones
    PropagationPlan plan;
    std::vector<PlannedLink> planned;
    std::vector<RigidWeld> welds;
    std::vector<PlannedPair> pairs;
    std::vector<PreparedLink> links;  //!< as planned
    std::vector<PreparedPart> parts;
    std::vector<std::vector<int>> stages;  //!< the plan's order; none of a stage moves another
    std::vector<ContactGauge> gauges;      //!< as plan.measured
    std::vector<Overlap> overlaps;         //!< of whole()
    std::vector<Timing> timings;

    //! Where all parts are solved at once: the one part that they are, and what is whose there.
    std::shared_ptr<const PreparedAssembly> joined;
    JoinedParts places = {};  //!< its assembly is moved to `joined`

    bool carries_thin = false;  //!< parts joined in it are thin solids, which read all rotations

    //! What is solved.
    const PreparedAssembly& system() const { return joined ? *joined : *this; }

    //! Whether a part is solved, alone or with the others.
    bool is_solved(int part) const
    {
        const auto index = static_cast<std::size_t>(part);
        return joined ? places.first[index] >= 0 : parts[index].deformer != nullptr;
    }

    //! Every part with all its vertices.
    const Assembly& whole() const { return with_thin_parts ? *with_thin_parts : assembly; }
};

//! Plans, then builds all parts and links in parallel, taking over from `previous` what fits.
PreparedAssembly prepare_assembly(Assembly assembly, const Progress& progress,
                                  const PreparedAssembly* previous);

//! What a pose tells the prepared assembly: with a plane of symmetry, of both sides.
//! \throws InvalidInput naming what the pose tells in vain, or differently on both sides
Pose told_pose(const PreparedAssembly& prepared, const Pose& pose);

//! Handles, with those that mirror them.
std::set<std::string> with_mirrors(const PreparedAssembly& prepared,
                                   const std::vector<std::string>& handles);

}  // namespace sheetmorph::assembly

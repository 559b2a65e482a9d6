// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/feature_sizes.h"
#include "sheetmorph/assembly/plan/overlaps.h"
#include "sheetmorph/assembly/session/deformation_session.h"
#include "sheetmorph/assembly/session/feature_error.h"
#include "sheetmorph/assembly/symmetry/symmetry_plan.h"
#include "sheetmorph/assembly/thin/thin_solver.h"

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

//! One part, ready to be told of a pose.
struct PreparedPart
{
    std::vector<FeatureEdges> edges;         //!< by feature of the part
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
    System system;
    std::vector<PreparedLink> links;  //!< as system.links
    std::vector<PreparedPart> parts;

    //! By sheet of the system; nothing if no pose moves it.
    std::vector<std::shared_ptr<const surface::SurfaceDeformer>> deformers;

    std::vector<ContactGauge> gauges;  //!< as system.plan.measured
    std::vector<Overlap> overlaps;     //!< of whole()
    std::vector<Timing> timings;

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

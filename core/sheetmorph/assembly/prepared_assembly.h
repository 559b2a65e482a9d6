// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/deformation_session.h"
#include "sheetmorph/assembly/feature_error.h"
#include "sheetmorph/assembly/part_problem.h"

namespace sheetmorph
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

//! One part, ready to be solved; no deformer if nothing moves it.
struct PreparedPart
{
    PartProblem problem;
    std::vector<FeatureEdges> edges;
    std::shared_ptr<const SurfaceDeformer> deformer;
};

//! Everything a session knows before a pose.
struct PreparedAssembly
{
    Assembly assembly;
    PropagationPlan plan;
    std::vector<PlannedLink> planned;
    std::vector<RigidWeld> welds;
    std::vector<PreparedLink> links;  //!< as planned
    std::vector<PreparedPart> parts;
    std::vector<ContactGauge> gauges;  //!< as plan.measured
    std::vector<Timing> timings;
};

//! Plans, then builds all parts and links in parallel, taking over from `previous` what fits.
PreparedAssembly prepare_assembly(Assembly assembly, const Progress& progress,
                                  const PreparedAssembly* previous);

}  // namespace sheetmorph

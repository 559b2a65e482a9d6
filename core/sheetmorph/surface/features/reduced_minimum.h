// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/joints.h"
#include "sheetmorph/surface/features/feature_responses.h"

namespace sheetmorph::surface
{

//! The data from which the energy of a configuration is computed.
struct Measure
{
    const PlacementInput& part;
    const FeatureResponses& responses;
    const ReducedEnergy& energy;
};

//! Entries (c, 3) of the rotating bodies' motions, in the order of ReducedEnergy.
Eigen::MatrixXd entries_of(const Joints& joints, const PlacementInput& part,
                           const FeatureResponses& responses);

//! Moves the joints to the nearest local minimum of the energy by newton_minimum() on their
//! freedoms. It uses the full second derivative, modified to be positive definite where necessary.
//! Directions without effect on the energy stay unchanged.
//! \param precision  radians; ends after the first step below it. The error after a step is of the
//!                   order of its square.
[[nodiscard]] Convergence minimise(Joints& joints, const Measure& measure, double precision = 0.0);

}  // namespace sheetmorph::surface

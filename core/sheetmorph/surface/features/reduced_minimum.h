// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/joints.h"
#include "sheetmorph/surface/features/feature_responses.h"

namespace sheetmorph::surface
{

//! What a configuration is measured with.
struct Measure
{
    const PlacementInput& part;
    const FeatureResponses& responses;
    const ReducedEnergy& energy;
};

//! Entries (c, 3) of the turners' motions, as a ReducedEnergy counts them.
Eigen::MatrixXd entries_of(const Joints& joints, const PlacementInput& part,
                           const FeatureResponses& responses);

//! Moves the joints to the minimum of the energy near where they are: newton_minimum() on their own
//! freedoms, with the full second derivative, made positive where it is not.
//! Directions the energy does not feel stay as they are.
//! \param precision  radians: the first step this small is the last. Steps square what is left.
[[nodiscard]] Convergence minimise(Joints& joints, const Measure& measure, double precision = 0.0);

}  // namespace sheetmorph::surface

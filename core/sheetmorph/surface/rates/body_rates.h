// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/body_motions.h"
#include "sheetmorph/surface/rates/target_rates.h"

namespace sheetmorph::surface
{

//! Targets with how they change.
struct TargetsInMotion
{
    const SurfaceTargets& targets;
    const TargetRates& rates;
};

//! Of known_body_motions(): about the bodies' centres; those of bodies that the energy or the field
//! moves are none yet.
//! \throws NoDerivative for bodies that links or motions bind to what carries them
std::vector<MotionRate> known_body_rates(const PlacementInput& part, const BodyMotions& known,
                                         const TargetsInMotion& pose);

//! Of given_rotations().
KnownRotations given_rotation_rates(const PlacementInput& part, const TargetRates& rates,
                                    const std::vector<MotionRate>& bodies);

//! (n, 3) how the vertices move whose places the pose knows, and those of bodies.
Eigen::MatrixXd known_velocities(const PlacementInput& part, const TargetsInMotion& pose,
                                 const BodyMotions& motions, const std::vector<MotionRate>& bodies);

//! Gives clamped vertices the rows of those that they move with.
//! \param given, rates  the rotations that the pose gives, and how they change
void move_clamped(const PlacementInput& part, const KnownRotations& given,
                  const KnownRotations& rates, Eigen::MatrixXd& velocities);

}  // namespace sheetmorph::surface

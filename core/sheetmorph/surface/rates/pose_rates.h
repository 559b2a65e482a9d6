// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/features/reduced_expansion.h"
#include "sheetmorph/surface/rates/target_rates.h"
#include "sheetmorph/surface/solve/pose_steps.h"

namespace sheetmorph::surface
{

//! How one part answers to small changes of a pose: its exact answer is differentiated, with the
//! factors that are there. The linear solves are differentiated as they are, of what the energy
//! turns the minimum (its gradient stays zero), of rotations the closed forms.
class PoseRates
{
public:
    //! \throws NoDerivative for `steel`, refined answers, links between features, and where
    //! features
    //!         are held at the field's rotation or a sheet is turned by about a whole turn
    PoseRates(const PreparedSurface& part, SurfaceTargets targets);
    PoseRates(const PoseRates&) = delete;
    PoseRates& operator=(const PoseRates&) = delete;

    //! \throws NoDerivative as the constructor
    DeformationRate along(const TargetRates& rates) const;

private:
    struct Direction;
    void solve_turners();
    void turn_open(Direction& direction) const;
    void turn_features(Direction& direction) const;
    std::vector<Matrix3> turn_rates(const Direction& direction,
                                    const std::vector<Vector3>& spins) const;
    numerics::ConstrainedMinimiser::Targets asked(const Direction& direction,
                                                  const std::vector<Vector3>& spins,
                                                  const std::vector<MotionRate>& bodies) const;
    std::vector<StateRate> driven(const TargetRates& rates) const;
    void blend(Direction& direction) const;
    void complete(Direction& direction, const Eigen::MatrixXd& velocities) const;
    DeformationRate placed(const Direction& direction, const Eigen::MatrixXd& velocities) const;
    void grow(const TargetRates& rates, DeformationRate& rate) const;

    const PreparedSurface& part_;
    PlacementInput placement_;
    SurfaceTargets targets_;
    SizeChanges sizes_;
    BodyMotions known_;
    GivenRotations given_;
    Field field_;
    BodyMotions start_;  // what the turners start from
    std::optional<Turned> turned_;
    Expansion expansion_;         // at the turners' minimum
    BodyMotions bodies_;          // turned
    std::vector<Matrix3> turns_;  // (n) of the field
    Eigen::VectorXd shares_;      // (n) what of the sheet's turn is the field's
    Points logs_;                 // (n, 3) of the sheet
};

}  // namespace sheetmorph::surface

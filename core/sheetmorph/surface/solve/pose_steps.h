// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/solve/prepared_surface.h"

namespace sheetmorph::surface
{

//! The rotation field of one pose.
struct Field
{
    Points logs;   //!< (n, 3)
    Points tilts;  //!< (n, 3)
    Points far;    //!< (r, 3) what rows gain where the sheet turns far (FarTurns); or no rows
    Convergence convergence = {};
};

Field field_of(const PreparedSurface& part, const GivenRotations& given);

//! By vertex: the share of its turn that is the field's, not that of turners.
Eigen::VectorXd shares_of_field(const PreparedSurface& part);

//! R - I at every vertex: the field, and of what turners own of it the rotation in `turns`, or none
//! of it where `turns` is empty.
std::vector<Matrix3> turns_of(const PreparedSurface& part, const Field& field,
                              const std::vector<BodyState>& turns);

//! A pose, its field, and where bodies are in it.
struct Told
{
    const SurfaceTargets& targets;
    const Field& field;
    const BodyMotions& bodies;
};

//! Asks the sheet for rest rows that turn like that, and for what moves as it is told.
//! \param change  turns_of()
void ask(const PreparedSurface& part, const std::vector<Matrix3>& change, const Told& told,
         numerics::ConstrainedMinimiser::Targets& asked);

//! What decides how the energy turns features in one pose; outlives the answer.
struct ToTurn
{
    const SurfaceTargets& targets;
    const BodyMotions& bodies;  //!< known ones, the others turned as the field has them
    const Field& field;
    int refinements = 1;     //!< of the base
    double precision = 0.0;  //!< minimise()
};

//! What the energy turns, at its minimum.
struct Turned
{
    numerics::ConstrainedMinimiser::Solution base;  //!< with every turner unmoved
    Eigen::MatrixXd slope;                          //!< (c, 3) that the sheet alone has there
    ReducedEnergy energy;
    bool is_held = false;  //!< a feature is held at the field's rotation (hold_far_turned())
    Joints joints;
    Convergence convergence;
};

//! Lets the energy turn what it may turn.
//! \param asked  gets what was asked for the base; its constraints are there already
Turned turned_features(const PreparedSurface& part, const ToTurn& pose,
                       numerics::ConstrainedMinimiser::Targets& asked);

}  // namespace sheetmorph::surface

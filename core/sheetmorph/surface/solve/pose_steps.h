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
    Points far;    //!< (r, 3) addition to the rows for large rotations (FarTurns); or no rows
    Convergence convergence = {};
};

Field field_of(const PreparedSurface& part, const GivenRotations& given);

//! By vertex: the field's share of the sheet's rotation; the rest belongs to rotating bodies.
Eigen::VectorXd shares_of_field(const PreparedSurface& part);

//! R - I at every vertex: the field's share, plus that of the rotating bodies with the rotations
//! `turns`. If `turns` is empty, the bodies contribute nothing.
std::vector<Matrix3> turns_of(const PreparedSurface& part, const Field& field,
                              const std::vector<BodyState>& turns);

//! A pose, its field, and the motions of its bodies.
struct Told
{
    const SurfaceTargets& targets;
    const Field& field;
    const BodyMotions& bodies;
};

//! Fills in the targets of the sheet: rotated rest rows and prescribed displacements.
//! \param change  turns_of()
void ask(const PreparedSurface& part, const std::vector<Matrix3>& change, const Told& told,
         numerics::ConstrainedMinimiser::Targets& asked);

//! Input of turned_features(); must outlive the result.
struct ToTurn
{
    const SurfaceTargets& targets;
    const BodyMotions& bodies;  //!< prescribed motions; other bodies have the rotation of the field
    const Field& field;
    int refinements = 1;     //!< for the base solution
    double precision = 0.0;  //!< see minimise()
};

//! The rotating bodies at the minimum of the energy.
struct Turned
{
    numerics::ConstrainedMinimiser::Solution base;  //!< with all rotating bodies unmoved
    Eigen::MatrixXd slope;  //!< (c, 3) slope of the sheet alone at the base solution
    ReducedEnergy energy;
    bool is_held = false;  //!< whether a feature is constrained (hold_far_turned())
    Joints joints;
    Convergence convergence;
};

//! Minimises the energy over the rotating bodies.
//! \param asked  filled with the targets of the base solution; its constraints must be set
Turned turned_features(const PreparedSurface& part, const ToTurn& pose,
                       numerics::ConstrainedMinimiser::Targets& asked);

}  // namespace sheetmorph::surface

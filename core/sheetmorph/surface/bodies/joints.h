// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/body_motions.h"
#include "sheetmorph/surface/bodies/turners.h"

namespace sheetmorph::surface
{

//! One factor of a body's possible motion: rotations about a point or translations, controlled by
//! the unknowns `first`, `first` + 1, ... of the reduced problem. Followers move along.
struct JointLevel
{
    bool is_turn = true;
    Vector3 point = Vector3::Zero();  //!< of rotations, mm
    std::vector<Vector3> axes;        //!< unit length
    int first = 0;
};

//! Bodies in the reduced problem of one pose. Their states always satisfy their motions and links.
class Joints
{
public:
    //! \param bodies  prescribed motions; the other bodies start with the rotation of the field
    Joints(const PlacementInput& part, const SurfaceTargets& targets,
           const std::vector<Turner>& turners, const BodyMotions& bodies);

    int freedoms() const { return freedoms_; }
    const std::vector<BodyState>& states() const { return states_; }

    //! Every level that moves rotating body k, outermost first.
    const std::vector<JointLevel>& levels(std::size_t k) const { return levels_[k]; }

    //! Moves all bodies by small unknowns q (freedoms).
    void step(const Eigen::VectorXd& q);

    //! Restores earlier states().
    void restore(const std::vector<BodyState>& states);

    //! Sets every body, also followers, exactly to its given motion.
    void start_as_known();

    //! The state of a body of the part: from its rotating body, or its prescribed motion.
    BodyState state_of_body(int body) const;

private:
    void place_at_start(const BodyMotions& bodies, std::size_t k);
    std::vector<JointLevel> own_levels(std::size_t k) const;
    BodyState leader_of(const Body& body) const;
    void renew_levels();

    PlacementInput part_;
    const SurfaceTargets& targets_;
    const std::vector<Turner>& turners_;
    const BodyMotions& known_;
    std::vector<int> turner_of_body_;
    std::vector<BodyState> states_;
    std::vector<std::vector<JointLevel>> levels_;
    int freedoms_ = 0;
};

}  // namespace sheetmorph::surface

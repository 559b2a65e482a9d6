// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/body_motions.h"
#include "sheetmorph/surface/bodies/turners.h"

namespace sheetmorph::surface
{

//! One factor of how a body may move: turns about a point, or shifts, by the numbers `first`,
//! `first` + 1, ... of the reduced problem. Whoever follows moves along.
struct JointLevel
{
    bool is_turn = true;
    Vector3 point = Vector3::Zero();  //!< mm, of turns
    std::vector<Vector3> axes;        //!< unit length
    int first = 0;
};

//! Bodies in the reduced problem of one pose: always where their motions and links allow.
class Joints
{
public:
    //! \param bodies  known motions; rotations of the others start as the field has them
    Joints(const PlacementInput& part, const SurfaceTargets& targets,
           const std::vector<Turner>& turners, const BodyMotions& bodies);

    int freedoms() const { return freedoms_; }
    const std::vector<BodyState>& states() const { return states_; }

    //! Every level that moves turner k, outermost first.
    const std::vector<JointLevel>& levels(std::size_t k) const { return levels_[k]; }

    //! Moves everything by small numbers q (freedoms).
    void step(const Eigen::VectorXd& q);

    //! Back to states() of before.
    void restore(const std::vector<BodyState>& states);

    //! Puts every body exactly where its known motion has it, those that follow others too.
    void start_as_known();

    //! Where a body of the part is: by its turner, or as it was known.
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

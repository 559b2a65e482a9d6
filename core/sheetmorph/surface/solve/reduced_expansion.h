// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/solve/reduced_minimum.h"

namespace sheetmorph
{

//! The reduced energy about one configuration of the joints.
struct Expansion
{
    double value = 0.0;
    Eigen::VectorXd gradient;  //!< (freedoms)
    Eigen::MatrixXd hessian;   //!< (freedoms, freedoms), the full second derivative
};

Expansion expand(const Joints& joints, const Measure& measure);

//! How one turner changes where the joints do.
struct StateRate
{
    Vector3 spin = Vector3::Zero();    //!< of its rotation
    Vector3 centre = Vector3::Zero();  //!< of its centre, mm
};

//! \param steps  (freedoms) how the joints' numbers change
std::vector<StateRate> state_rates(const Joints& joints, const Eigen::VectorXd& steps);

//! (freedoms) the gradient of an energy whose forces G rho + g are these (c, 3).
Eigen::VectorXd gradient_of(const Joints& joints, const FeatureResponses& responses,
                            const Eigen::MatrixXd& forces);

}  // namespace sheetmorph

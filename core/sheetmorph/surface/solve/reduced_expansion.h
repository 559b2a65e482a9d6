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

}  // namespace sheetmorph

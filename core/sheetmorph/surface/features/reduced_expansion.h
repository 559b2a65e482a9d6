// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/features/reduced_minimum.h"

namespace sheetmorph::surface
{

//! The reduced energy where the joints are.
struct Forces
{
    Points entries;  //!< rho (c, 3)
    Points pull;     //!< G rho + g (c, 3)
    double value = 0.0;
};

Forces forces_at(const Joints& joints, const Measure& measure);

//! The same about one configuration of the joints.
struct Expansion
{
    Eigen::VectorXd gradient;  //!< (freedoms)
    Eigen::MatrixXd hessian;   //!< (freedoms, freedoms), the full second derivative
};

Expansion expand(const Joints& joints, const Measure& measure, const Forces& forces);

//! The same where every turner turns about three axes and does nothing else: products with the
//! second derivative instead of it. With dR = [e] R of every turner, and M = R_k G_kl R_l^T of two,
//! it is 2 (tr M - M^T), and N + N^T - 2 tr N of one turner, N = R F for the forces F on it.
class TurnExpansion
{
public:
    //! Whether turners do nothing else, so that the others of these may be called.
    static bool is_possible(const Joints& joints, const FeatureResponses& responses);

    TurnExpansion(const Joints& joints, const Measure& measure, const Forces& forces);

    const Eigen::VectorXd& gradient() const { return gradient_; }  //!< (freedoms)

    Eigen::VectorXd times(const Eigen::VectorXd& q) const;

    //! Solves it as it is at rest, every turner turned with what is around it: near the inverse.
    Eigen::VectorXd nearly_solved(const Eigen::VectorXd& q) const;

private:
    std::vector<Matrix3> rotations_, curvatures_;
    Eigen::VectorXd gradient_;
    const numerics::Weights& stiffness_;
    const numerics::DenseCholesky& at_rest_;
};

//! (freedoms) the gradient of an energy whose forces G rho + g are these (c, 3).
Eigen::VectorXd gradient_of(const Joints& joints, const FeatureResponses& responses,
                            const Eigen::MatrixXd& forces);

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/features/reduced_minimum.h"

namespace sheetmorph::surface
{

//! The reduced energy at the current state of the joints.
struct Forces
{
    Points entries;  //!< rho (c, 3)
    Points pull;     //!< G rho + g (c, 3)
    double value = 0.0;
};

Forces forces_at(const Joints& joints, const Measure& measure);

//! Gradient and Hessian of the reduced energy at one configuration of the joints.
struct Expansion
{
    Eigen::VectorXd gradient;  //!< (freedoms)
    Eigen::MatrixXd hessian;   //!< (freedoms, freedoms), the full second derivative
};

Expansion expand(const Joints& joints, const Measure& measure, const Forces& forces);

//! The same if every rotating body only rotates about three axes. It computes products with the
//! second derivative instead of the matrix. With dR = [e] R for every rotating body, two of them
//! contribute 2 (tr M - M^T), M = R_k G_kl R_l^T. One contributes N + N^T - 2 tr N, N = R F with
//! the forces F on it.
class TurnExpansion
{
public:
    //! Whether all rotating bodies only rotate. Required by all other members.
    static bool is_possible(const Joints& joints, const FeatureResponses& responses);

    TurnExpansion(const Joints& joints, const Measure& measure, const Forces& forces);

    const Eigen::VectorXd& gradient() const { return gradient_; }  //!< (freedoms)

    Eigen::VectorXd times(const Eigen::VectorXd& q) const;

    //! Approximate solution with the factor at rest, rotated with the bodies; a preconditioner.
    Eigen::VectorXd nearly_solved(const Eigen::VectorXd& q) const;

private:
    std::vector<Matrix3> rotations_, curvatures_;
    Eigen::VectorXd gradient_;
    const numerics::Weights& stiffness_;
    const numerics::DenseCholesky& at_rest_;
};

//! (freedoms) gradient of an energy with forces G rho + g (c, 3).
Eigen::VectorXd gradient_of(const Joints& joints, const FeatureResponses& responses,
                            const Eigen::MatrixXd& forces);

}  // namespace sheetmorph::surface

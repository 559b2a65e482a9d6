// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

namespace sheetmorph
{

//! Rotations exp(sum_s w_s c_s), w the weights of one or two turning handles,
//! expanded in polynomials of w: R - I = sum_k M_k q_k(w). The polynomials know
//! the weights, the matrices M_k the pose. None has a constant term: where w =
//! 0 nothing turns.
class RotationSeries
{
public:
    //! \param weights  (n, s) of every vertex; they are blends (none negative,
    //! sum at most one) or
    //!                 any numbers
    RotationSeries(const Eigen::MatrixXd& weights, int degree);

    int count() const { return static_cast<int>(transform_.cols()); }

    //! \returns (n, count) q_k at every row of `weights` (n, s)
    Eigen::MatrixXd values(const Eigen::MatrixXd& weights) const;

    //! (count) about the largest entries that M_k takes on, whatever the turn up to a half one; at
    //! least 1e-3.
    Eigen::VectorXd reach() const;

    struct Fit
    {
        std::vector<Matrix3> matrices;  //!< M_k
        double error;                   //!< largest entry by which the sum misses R - I
    };

    //! \param logs  c_s (2.6), one a handle
    Fit fit(const std::vector<Vector3>& logs) const;

private:
    Eigen::MatrixXd raw_values(const Eigen::MatrixXd& weights) const;

    int degree_;
    Eigen::RowVectorXd lowest_,
        highest_;                 // of each weight: the polynomials live between them
    Eigen::MatrixXd transform_;   // makes them orthonormal on the samples
    Eigen::MatrixXd samples_;     // (m, s) weights
    Eigen::MatrixXd at_samples_;  // (m, count), orthogonal columns of norm sqrt(m)
};

}  // namespace sheetmorph

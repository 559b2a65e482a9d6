// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"

#include <Eigen/SparseCore>

namespace sheetmorph::volume
{

//! Fits a control mesh to displaced samples (3.3), as a displacement d about a rigid motion:
//! min_d sum_i a_i |u_i - (W d)_i|^2 + c (n / m) sum_j |(L d)_j|^2 ,
//! with uniform L and mean(a_i) = 1. As printed, (3.3) also moves parts at rest, and (3.2), without
//! c, is noisy. The constructor factorises.
class ControlMeshFit
{
public:
    //! \param sample_weights  W, (n, m): mean value coordinates of the samples
    //! \param areas           n, >= 0, any unit: weights of the samples
    //! \param laplacian       L, (m, m), of the control shape
    //! \param smoothness      c > 0, no unit
    //! \throws InvalidInput if the sizes disagree, no area is positive, or c is not positive
    ControlMeshFit(const numerics::Weights& sample_weights, const Eigen::VectorXd& areas,
                   const Eigen::SparseMatrix<double>& laplacian, double smoothness);

    //! \param sample_displacements  u, (n, 3) mm: displacements relative to the rigid motion
    //! \returns                     d, (m, 3) mm; exactly zero for zeros
    Points displacements(const Points& sample_displacements) const;

    //! W^T diag(a), transposed, (n, m). Together with factor(), it gives a composed operator.
    const numerics::Weights& weighted_samples() const { return weighted_; }
    const numerics::DenseCholesky& factor() const { return factor_; }

private:
    numerics::Weights weighted_;
    numerics::DenseCholesky factor_;
};

}  // namespace sheetmorph::volume

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/products/dense_products.h"

namespace sheetmorph::numerics
{

//! Replaces the first k columns of a symmetric positive definite matrix of r rows by those of its
//! Cholesky factor.
//! \param panel           (r, k), lower triangle used; above it the result is undefined
//! \param inverse_blocks  inverses of the diagonal blocks of the factor, one below the other
//! \throws SolverError if the matrix is not positive definite
void factorise_columns(WeightsTarget panel, Weights& inverse_blocks);

//! result -= rows rows^T, in its lower triangle; above it the result is undefined.
//! \param rows    (r, k)
//! \param result  (r, r)
void subtract_own_product(const WeightsView& rows, WeightsTarget result);

//! Cholesky factor N = L L^T of a dense symmetric positive definite matrix of a few hundred rows.
class DenseCholesky
{
public:
    //! \param matrix  (m, m), lower triangle used
    //! \throws SolverError if the matrix is not positive definite
    explicit DenseCholesky(Weights matrix);

    //! The smallest diagonal entry of L.
    double smallest_pivot() const { return lower_.diagonal().minCoeff(); }

    //! N^-1 right, (m, 3).
    Points solve(const Points& right) const;

    //! N^-1 right, (m), for one right-hand side.
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

    //! L^-T right, (m, 3): the second half of solve().
    Points solve_upper(const Points& right) const;

    //! rows * L^-T, (r, m). The product of two such results, the second transposed, is rows N^-1
    //! others^T.
    Weights half_solve_rows(Weights rows) const;

private:
    Weights lower_;
    Weights inverse_blocks_;  // of the diagonal blocks, one below the other
};

}  // namespace sheetmorph::numerics

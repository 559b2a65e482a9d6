// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/elimination.h"

#include <string>

namespace sheetmorph
{

//! Factor of a sparse symmetric positive definite matrix, by CHOLMOD or along a tree.
//! The constructor factorises, solve() only substitutes; solve() may run in several threads at
//! once.
class SparseCholesky
{
public:
    //! \param matrix  (n, n), symmetric
    //! \throws SolverError if the matrix is not positive definite
    explicit SparseCholesky(const SparseMatrix& matrix);

    //! \param tree     of the whole matrix; none: an order of elimination is looked for
    //! \param earlier  of the same whole matrix with other rows merged or left out, if there is
    //!                 one: what does not change is taken over
    SparseCholesky(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree,
                   const SparseCholesky* earlier = nullptr);
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    //! \param right_sides  (n, k)
    //! \returns            (n, k), the solutions
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right_sides) const;

    Eigen::Index size() const;

    //! Entries of the factor, for memory and fill reports.
    double factor_entries() const;

private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

//! diag(factors) * matrix; Eigen's own expression for it moves memory at every column.
SparseMatrix rows_scaled(const SparseMatrix& matrix, const Eigen::VectorXd& factors);

//! B^T diag(w) B.
SparseMatrix own_product(const SparseMatrix& rows, const Eigen::VectorXd& weights);

//! Versions of the linear algebra libraries in use, for reports.
std::string linear_algebra_versions();

}  // namespace sheetmorph

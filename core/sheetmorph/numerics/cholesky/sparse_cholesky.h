// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front_solver.h"

#include <string>

namespace sheetmorph::numerics
{

//! Factor of a sparse symmetric positive definite matrix along a tree of separators. solve() only
//! substitutes, and several threads may call it at once.
class SparseCholesky
{
public:
    //! \param tree     of the whole matrix
    //! \param earlier  optional, a factor of the same whole matrix with other rows merged or left
    //!     out; unchanged fronts are reused
    //! \throws SolverError if the merged matrix is not positive definite
    SparseCholesky(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree,
                   const SparseCholesky* earlier = nullptr);

    //! A factor without values. Call factorise() before solve().
    explicit SparseCholesky(std::shared_ptr<const FrontPattern> pattern);

    //! Factorises another matrix of the same pattern in the same memory. Does not change fronts
    //! that other factors share.
    //! \param whole  before rows are merged or left out
    //! \throws SolverError if the merged matrix is not positive definite; then only factorise() may
    //!     follow
    void factorise(const SparseMatrix& whole);

    //! \param right_sides  (n, k)
    //! \returns            (n, k), the solutions
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right_sides) const;

    //! right^T N^-1 right (k, k) of the merged matrix N.
    //! \param right  (n, k)
    Weights solved_product(const SparseMatrix& right) const;

    Eigen::Index size() const { return pattern_->elimination().matrix().count; }

    //! Number of entries of the factor, for reports of memory and fill.
    double factor_entries() const { return solver_.factor().count(); }

private:
    SparseCholesky(std::shared_ptr<const FrontPattern> pattern, const SparseCholesky* earlier);
    void find_values(const SparseMatrix& whole);
    int slot_of(Eigen::Index unknown) const
    {
        return pattern_->elimination().slot_of(static_cast<int>(unknown));
    }

    std::shared_ptr<const FrontPattern> pattern_;
    FrontSolver solver_;
};

//! diag(factors) * matrix. Eigen's own expression would move memory at every column.
SparseMatrix rows_scaled(const SparseMatrix& matrix, const Eigen::VectorXd& factors);

//! B^T diag(w) B.
SparseMatrix own_product(const SparseMatrix& rows, const Eigen::VectorXd& weights);

//! Version of the linear algebra library in use, for reports.
std::string linear_algebra_version();

}  // namespace sheetmorph::numerics

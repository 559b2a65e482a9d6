// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front_solver.h"
#include "sheetmorph/numerics/elimination.h"

#include <string>

namespace sheetmorph
{

//! Factor of a sparse symmetric positive definite matrix along a tree of separators.
//! The constructor factorises, solve() only substitutes; solve() may run in several threads at
//! once.
class SparseCholesky
{
public:
    //! \param tree     of the whole matrix
    //! \param earlier  of the same whole matrix with other rows merged or left out, if there is
    //!                 one: what does not change is taken over
    //! \throws SolverError if the merged matrix is not positive definite
    SparseCholesky(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree,
                   const SparseCholesky* earlier = nullptr);

    //! \param right_sides  (n, k)
    //! \returns            (n, k), the solutions
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right_sides) const;

    //! right^T N^-1 right (k, k) of the merged matrix N.
    //! \param right  (n, k)
    Weights solved_product(const SparseMatrix& right) const;

    Eigen::Index size() const { return elimination_.matrix().count; }

    //! Entries of the factor, for memory and fill reports.
    double factor_entries() const { return solver_.factor().count(); }

private:
    FrontList fronts(const SparseCholesky* earlier) const;

    Elimination elimination_;
    FrontSolver solver_;
};

//! diag(factors) * matrix; Eigen's own expression for it moves memory at every column.
SparseMatrix rows_scaled(const SparseMatrix& matrix, const Eigen::VectorXd& factors);

//! B^T diag(w) B.
SparseMatrix own_product(const SparseMatrix& rows, const Eigen::VectorXd& weights);

//! Version of the linear algebra library in use, for reports.
std::string linear_algebra_version();

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <Eigen/SparseCore>
#include <memory>
#include <string>

namespace sheetmorph
{

using SparseMatrix = Eigen::SparseMatrix<double>;

//! Factor of a sparse symmetric positive definite matrix (CHOLMOD).
//! The constructor factorises, solve() only substitutes; solve() may run in several threads at
//! once.
class SparseCholesky
{
public:
    //! \param matrix  (n, n), symmetric
    //! \param places  (n, 3) where the unknowns lie, if on a surface: large matrices are ordered
    //!                by them
    //! \throws SolverError if the matrix is not positive definite
    explicit SparseCholesky(const SparseMatrix& matrix, const Points& places = {});
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

//! Versions of the linear algebra libraries in use, for reports.
std::string linear_algebra_versions();

}  // namespace sheetmorph

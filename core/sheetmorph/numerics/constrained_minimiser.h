// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include <Eigen/QR>

namespace sheetmorph::numerics
{

//! The parts of a quadratic energy that do not depend on the pose.
struct QuadraticProblem
{
    SparseMatrix rows;         //!< B (r, n)
    Eigen::VectorXd weights;   //!< w (r), positive
    SparseMatrix basis;        //!< S (n, y): u = S y + offset, at most one entry 1 per row
    SparseMatrix constraints;  //!< C (c, n), may have no rows

    //! Rows of the constraints without which the energy would not be positive definite.
    std::vector<int> supporting;

    //! B^T diag(w) B (n, n); computed if missing.
    std::shared_ptr<const SparseMatrix> stiffness;

    //! Order of elimination of the stiffness.
    std::shared_ptr<const SeparatorTree> tree;
};

//! Minimises sum_r w_r |(B u - f)_r|^2 over u = S y + offset subject to C u = c (2.10). The basis S
//! eliminates most constraints. The few rows of C use a Schur complement over the same factor.
class ConstrainedMinimiser
{
public:
    //! \param earlier  optional, of the same stiffness and tree with another basis; unchanged parts
    //!     are reused
    //! \throws SolverError if the energy has no unique minimum
    explicit ConstrainedMinimiser(QuadraticProblem problem,
                                  const ConstrainedMinimiser* earlier = nullptr);

    struct Targets
    {
        Eigen::MatrixXd rows;         //!< f (r, k)
        Eigen::MatrixXd offset;       //!< (n, k)
        Eigen::MatrixXd constraints;  //!< c (c, k)
    };

    struct Solution
    {
        Eigen::MatrixXd u;             //!< (n, k)
        Eigen::MatrixXd multipliers;   //!< (c, k) of C u = c
        Convergence convergence = {};  //!< of the refinement
    };

    //! The residual at a minimum. Forces vanish in all directions of the basis.
    struct Balance
    {
        Eigen::MatrixXd residual;  //!< (r, k) B u - f
        Eigen::MatrixXd forces;    //!< (n, k) B^T W (B u - f) + C^T multipliers
    };

    //! \param refinements  most steps of iterative refinement on the residual in factored form;
    //!     fewer if they no longer change the result
    //! \returns u (n, k). Redundant constraints are met, contradicting ones on average; if they can
    //!     occur, check with constraint_error().
    Eigen::MatrixXd solve(const Targets& targets, int refinements) const;

    //! The same, with the data for balance().
    Solution minimum(const Targets& targets, int refinements) const;

    Balance balance(const Targets& targets, const Solution& solution) const;

    //! Energies at the minima for sparse targets with C u = 0, for all pairs of columns: (B u -
    //! f)^T W (B u - f), exact to rounding of the energy of a rigid sheet.
    //! \param rows    f (r, k)
    //! \param offset  (n, k)
    //! \returns        (k, k), symmetric
    Weights energies(const SparseMatrix& rows, const SparseMatrix& offset) const;

    //! (c) largest violation of each constraint by u.
    Eigen::VectorXd constraint_error(const Eigen::MatrixXd& u, const Eigen::MatrixXd& c) const;

    double factor_entries() const { return factor_.factor_entries(); }

private:
    struct Step;
    Step correct(const Eigen::MatrixXd& gradient, const Eigen::MatrixXd& violation) const;
    void factor_schur_complement();

    QuadraticProblem problem_;
    SparseMatrix reduced_constraints_;  // G = C S
    double support_ = 0.0;              // weight of the supporting constraints in the factor
    SparseCholesky factor_;
    Eigen::MatrixXd responses_;  // H^-1 G^T (y, c)
    Eigen::VectorXd scale_;      // of the Schur complement's rows
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> schur_;
};

}  // namespace sheetmorph::numerics

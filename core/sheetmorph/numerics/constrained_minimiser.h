// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include <Eigen/QR>

namespace sheetmorph::numerics
{

//! The parts of a quadratic energy that no pose changes.
struct QuadraticProblem
{
    SparseMatrix rows;         //!< B (r, n)
    Eigen::VectorXd weights;   //!< w (r), positive
    SparseMatrix basis;        //!< S (n, y): u = S y + offset, one entry 1 a row at most
    SparseMatrix constraints;  //!< C (c, n), may have no rows

    //! Constraints, by row, without which the energy alone would not be positive definite.
    std::vector<int> supporting;

    //! B^T diag(w) B (n, n); computed if it is not there.
    std::shared_ptr<const SparseMatrix> stiffness;

    //! Of the stiffness: the order of elimination.
    std::shared_ptr<const SeparatorTree> tree;
};

//! Minimises sum_r w_r |(B u - f)_r|^2 over u = S y + offset subject to C u = c (2.10).
//! Constraints by elimination; the few rows of C through a Schur complement over the same factor.
class ConstrainedMinimiser
{
public:
    //! \param earlier  of the same stiffness and tree, with another basis: what does not change is
    //!                 taken over
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
        Convergence convergence = {};  //!< of more refinements than one
    };

    //! What is left at a minimum: forces vanish on everything the basis can move.
    struct Balance
    {
        Eigen::MatrixXd residual;  //!< (r, k) B u - f
        Eigen::MatrixXd forces;    //!< (n, k) B^T W (B u - f) + C^T multipliers
    };

    //! \param refinements  most steps of iterative refinement on the residual in factored form;
    //!                     fewer are taken once they change nothing that counts
    //! \returns u (n, k); redundant constraints are met, contradicting ones in the mean: compare
    //!          C u with c (constraint_error) where they can occur
    Eigen::MatrixXd solve(const Targets& targets, int refinements) const;

    //! The same with what balance() needs.
    Solution minimum(const Targets& targets, int refinements) const;

    Balance balance(const Targets& targets, const Solution& solution) const;

    //! Of the columns of sparse targets, C u = 0: what the energy at their minima is in any blend
    //! of them, (B u - f)^T W (B u - f), to rounding of what it would be if nothing yielded. \param
    //! rows    f (r, k) \param offset  (n, k) \returns       (k, k), symmetric
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

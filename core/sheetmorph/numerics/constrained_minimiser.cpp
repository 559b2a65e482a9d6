// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/constrained_minimiser.h"

#include "sheetmorph/numerics/products/row_products.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::numerics
{

namespace
{

// Relative change of the answer at which refinement ends. From rounding: about 5 units of the last
// digit. Refinement also ends after a step that shrank by less than half, because only rounding is
// left then.
constexpr double settled = 1e-15;

// Relative change that a converged answer may still need. From the accuracy that SheetMorph
// promises: rigid motions to 1e-9 of the size (mathematics.md, section 8).
constexpr double found_to = 1e-9;

double largest(const Eigen::MatrixXd& matrix)
{
    return matrix.size() == 0 ? 0.0 : matrix.cwiseAbs().maxCoeff();
}

SparseMatrix supporting_rows(const SparseMatrix& constraints, const std::vector<int>& ids)
{
    SparseMatrix pick(static_cast<Eigen::Index>(ids.size()), constraints.rows());
    for (std::size_t k = 0; k < ids.size(); ++k)
        pick.insert(static_cast<Eigen::Index>(k), ids[k]) = 1.0;
    return pick * constraints;
}

// Constraints that determine a part's position enter the factor with a weight as large as the
// stiffness of the energy. The minimum under the exact constraints does not depend on this weight.
double support_weight(const QuadraticProblem& problem)
{
    if (problem.supporting.empty() || problem.basis.cols() == 0)
        return 0.0;
    return problem.stiffness->diagonal().maxCoeff();
}

MergedMatrix reduced_hessian(const QuadraticProblem& problem, double support)
{
    MergedMatrix hessian{problem.stiffness,
                         std::vector<int>(static_cast<std::size_t>(problem.basis.rows()), -1),
                         static_cast<int>(problem.basis.cols())};
    for (Eigen::Index column = 0; column < problem.basis.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(problem.basis, column); entry; ++entry)
            hessian.unknown_of[static_cast<std::size_t>(entry.row())] = static_cast<int>(column);
    if (support != 0.0)
    {
        const SparseMatrix rows = supporting_rows(problem.constraints, problem.supporting);
        hessian.whole = std::make_shared<const SparseMatrix>(
            *problem.stiffness + support * SparseMatrix(SparseMatrix(rows.transpose()) * rows));
    }
    return hessian;
}

// A^T diag(w) A, dense, row by row, because rows have few entries.
Weights weighted_squares(const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows,
                         const Eigen::VectorXd& weights)
{
    using Entry = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    Weights squares = Weights::Zero(rows.cols(), rows.cols());
    for (Eigen::Index row = 0; row < rows.outerSize(); ++row)
        for (Entry one(rows, row); one; ++one)
            for (Entry other(rows, row); other && other.col() <= one.col(); ++other)
                squares(one.col(), other.col()) += weights(row) * one.value() * other.value();
    return squares.selfadjointView<Eigen::Lower>();
}

QuadraticProblem with_stiffness(QuadraticProblem problem)
{
    if (!problem.stiffness)
        problem.stiffness =
            std::make_shared<const SparseMatrix>(own_product(problem.rows, problem.weights));
    return problem;
}

}  // namespace

struct ConstrainedMinimiser::Step
{
    Eigen::MatrixXd unknowns;
    Eigen::MatrixXd multipliers;
};

ConstrainedMinimiser::ConstrainedMinimiser(QuadraticProblem problem,
                                           const ConstrainedMinimiser* earlier)
    : problem_(with_stiffness(std::move(problem))),
      reduced_constraints_(problem_.constraints * problem_.basis),
      support_(support_weight(problem_)),
      factor_(reduced_hessian(problem_, support_), problem_.tree,
              earlier != nullptr ? &earlier->factor_ : nullptr)
{
    factor_schur_complement();
}

void ConstrainedMinimiser::factor_schur_complement()
{
    if (reduced_constraints_.rows() == 0)
        return;
    responses_ = factor_.solve(Eigen::MatrixXd(reduced_constraints_.transpose()));
    const Eigen::MatrixXd complement = reduced_constraints_ * responses_;
    scale_ = complement.diagonal().unaryExpr(
        [](double stiffness) { return stiffness > 0.0 ? 1.0 / std::sqrt(stiffness) : 0.0; });
    // The rows have unit length. Chosen between the rounding of redundant constraints (1e-15) and
    // the pivots of independent ones, which a condition of 1e6 would lower to 1e-12.
    schur_.setThreshold(1e-12);
    schur_.compute(scale_.asDiagonal() * complement * scale_.asDiagonal());
}

// Solves [H G^T; G 0] [y; m] = [gradient; violation]. The factor may be that of H + s G_s^T G_s.
// Then s G_s^T violation_s is added to the right-hand side.
ConstrainedMinimiser::Step ConstrainedMinimiser::correct(const Eigen::MatrixXd& gradient,
                                                         const Eigen::MatrixXd& violation) const
{
    if (reduced_constraints_.rows() == 0)
        return {factor_.solve(gradient), violation};
    Eigen::MatrixXd right_side = gradient;
    if (support_ != 0.0)
    {
        Eigen::MatrixXd held = Eigen::MatrixXd::Zero(violation.rows(), violation.cols());
        for (const int row : problem_.supporting)
            held.row(row) = violation.row(row);
        right_side += support_ * (reduced_constraints_.transpose() * held);
    }
    const Eigen::MatrixXd start = factor_.solve(right_side);
    const Eigen::MatrixXd excess = reduced_constraints_ * start - violation;
    const Eigen::MatrixXd multipliers =
        scale_.asDiagonal() * schur_.solve(scale_.asDiagonal() * excess);
    return {start - responses_ * multipliers, multipliers};
}

Eigen::MatrixXd ConstrainedMinimiser::solve(const Targets& targets, int refinements) const
{
    return minimum(targets, refinements).u;
}

ConstrainedMinimiser::Balance ConstrainedMinimiser::balance(const Targets& targets,
                                                            const Solution& solution) const
{
    RowProducts products(problem_.rows, problem_.weights);
    Balance left;
    left.residual = -products.left(targets.rows, solution.u);
    left.forces = products.pull(left.residual);
    if (problem_.constraints.rows() != 0)
        left.forces += problem_.constraints.transpose() * solution.multipliers;
    return left;
}

ConstrainedMinimiser::Solution ConstrainedMinimiser::minimum(const Targets& targets,
                                                             int refinements) const
{
    const Eigen::Index columns = targets.rows.cols();
    Eigen::MatrixXd u = targets.offset;
    Eigen::MatrixXd unknowns = Eigen::MatrixXd::Zero(problem_.basis.cols(), columns);
    Eigen::MatrixXd multipliers = Eigen::MatrixXd::Zero(problem_.constraints.rows(), columns);
    double last_change = 0.0;
    Convergence convergence{"the positions", refinements < 2, 0, 0.0};
    RowProducts products(problem_.rows, problem_.weights);
    for (int step = 0; step <= refinements; ++step)
    {
        Eigen::MatrixXd gradient = products.reduced_pull(targets.rows, u, problem_.basis);
        Eigen::MatrixXd violation = targets.constraints;
        if (problem_.constraints.rows() != 0)
        {
            gradient -= reduced_constraints_.transpose() * multipliers;
            violation -= problem_.constraints * u;
        }
        const Step change = correct(gradient, violation);
        unknowns += change.unknowns;
        multipliers += change.multipliers;
        u = expanded(problem_.basis, unknowns, targets.offset);
        const double changed = largest(change.unknowns);
        const double expected_next = step > 0 ? changed * changed / last_change : changed;
        convergence.rounds = step;
        convergence.miss = std::min(changed, expected_next);
        if (expected_next <= settled * largest(u) || (step > 1 && changed > 0.5 * last_change))
            break;
        last_change = changed;
    }
    convergence.is_converged |= convergence.miss <= found_to * largest(u);
    return {std::move(u), std::move(multipliers), convergence};
}

// With A = B offset - f, b = -S^T B^T W A and v = -C offset, the energy is A^T W A - q. Here q (b,
// v) is the value at the saddle point, b^T H^-1 b without constraints. As in correct(), the part s
// of supporting constraints in the factor is added to b, and subtracted again.
Weights ConstrainedMinimiser::energies(const SparseMatrix& rows, const SparseMatrix& offset) const
{
    const SparseMatrix unyielding = problem_.rows * offset - rows;
    const SparseMatrix weighted = rows_scaled(unyielding, problem_.weights);
    const SparseMatrix pulled = problem_.rows.transpose() * weighted;
    SparseMatrix gradient = -(problem_.basis.transpose() * pulled);
    Weights found = weighted_squares(unyielding, problem_.weights);
    if (reduced_constraints_.rows() == 0)
        return found - factor_.solved_product(gradient);
    const SparseMatrix violation = -(problem_.constraints * offset);
    if (support_ != 0.0)
    {
        const SparseMatrix held = supporting_rows(violation, problem_.supporting);
        const SparseMatrix pulls = supporting_rows(reduced_constraints_, problem_.supporting);
        gradient += support_ * (pulls.transpose() * held);
        found += support_ * weighted_squares(held, Eigen::VectorXd::Ones(held.rows()));
    }
    const Eigen::MatrixXd excess =
        scale_.asDiagonal() * (responses_.transpose() * gradient - Eigen::MatrixXd(violation));
    found += excess.transpose() * schur_.solve(excess);
    return found - factor_.solved_product(gradient);
}

Eigen::VectorXd ConstrainedMinimiser::constraint_error(const Eigen::MatrixXd& u,
                                                       const Eigen::MatrixXd& c) const
{
    if (problem_.constraints.rows() == 0)
        return {};
    return (problem_.constraints * u - c).cwiseAbs().rowwise().maxCoeff();
}

}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/steel/shell_minimum.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/QR>
#include <algorithm>
#include <deque>
#include <limits>
#include <optional>

namespace sheetmorph
{

namespace
{

constexpr double settled = 1e-7;       // of the size: a step that moves less is the last
constexpr double longest_step = 0.25;  // of the size
constexpr double widest_turn = 0.8;    // radians, of a body or a director
constexpr std::size_t remembered = 4;  // energies that a step is compared with
constexpr int first_rounds = 30;       // before the ladder
constexpr int ladder_rounds = 30;      // on each rung but the last
constexpr int last_rounds = 60;

//! The linear problem of one step, with the points as constraints.
class StepProblem
{
public:
    StepProblem(const ShellSystem::Tangent& tangent, const ShellSystem& shell,
                const SurfaceTargets& targets)
        : tangent_(tangent), shell_(shell), misses_(shell.point_misses(targets))
    {
        if (misses_.size() == 0)
            return;
        rows_ = shell.point_rows();
        weight_ = tangent.matrix->diagonal().cwiseAbs().mean();
        add_rows();
    }

    //! Nothing where the tangent is not positive definite.
    std::optional<Eigen::VectorXd> solve(double shift) const
    {
        try
        {
            MergedMatrix whole{tangent_.matrix, {}, shell_.unknowns()};
            whole.unknown_of.resize(static_cast<std::size_t>(shell_.unknowns()));
            for (int k = 0; k < shell_.unknowns(); ++k)
                whole.unknown_of[static_cast<std::size_t>(k)] = k;
            if (shift > 0.0)
                whole.whole = shifted(shift);
            const SparseCholesky factor(std::move(whole), shell_.tree());
            return constrained(factor);
        }
        catch (const SolverError&)
        {
            return std::nullopt;
        }
    }

private:
    // Adds weight * C^T C, which holds what only points hold.
    void add_rows()
    {
        const SparseMatrix product = SparseMatrix(rows_.transpose()) * rows_;
        SparseMatrix& matrix = *tangent_.matrix;
        for (Eigen::Index column = 0; column < product.outerSize(); ++column)
            for (SparseMatrix::InnerIterator entry(product, column); entry; ++entry)
            {
                const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
                const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
                const int* found = std::lower_bound(begin, end, static_cast<int>(entry.row()));
                if (found != end && *found == entry.row())
                    matrix.valuePtr()[found - matrix.innerIndexPtr()] += weight_ * entry.value();
            }
    }

    std::shared_ptr<const SparseMatrix> shifted(double shift) const
    {
        auto matrix = std::make_shared<SparseMatrix>(*tangent_.matrix);
        for (Eigen::Index column = 0; column < matrix->outerSize(); ++column)
            for (SparseMatrix::InnerIterator entry(*matrix, column); entry; ++entry)
                if (entry.row() == column)
                    entry.valueRef() *= 1.0 + shift;
        return matrix;
    }

    Eigen::VectorXd constrained(const SparseCholesky& factor) const
    {
        if (misses_.size() == 0)
            return factor.solve(-tangent_.gradient);
        const Eigen::VectorXd right = -tangent_.gradient + weight_ * (rows_.transpose() * misses_);
        const Eigen::VectorXd open = factor.solve(right);
        const Eigen::MatrixXd responses =
            factor.solve(Eigen::MatrixXd(SparseMatrix(rows_.transpose())));
        const Eigen::MatrixXd schur = rows_ * responses;
        const Eigen::VectorXd multipliers =
            schur.completeOrthogonalDecomposition().solve(misses_ - rows_ * open);
        return open + responses * multipliers;
    }

    const ShellSystem::Tangent& tangent_;
    const ShellSystem& shell_;
    Eigen::VectorXd misses_;
    SparseMatrix rows_;
    double weight_ = 0.0;
};

//! Newton's method for one thickness.
class Newton
{
public:
    Newton(ShellSystem& shell, const ShellTask& task, double thickness)
        : shell_(shell), task_(task), bending_(thickness * thickness / 12.0)
    {
    }

    Convergence run(int most_rounds, const Progress& progress)
    {
        Convergence found{"the positions of the sheet", false, 0, 0.0};
        stresses_ = shell_.no_stresses();
        energies_ = {merit()};
        for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
        {
            progress.report(static_cast<double>(found.rounds) / most_rounds,
                            "steel: round " + std::to_string(found.rounds + 1));
            found.miss = step();
            found.is_converged = found.miss <= settled * task_.size;
        }
        return found;
    }

private:
    // What points miss costs as much as the sheet's own stretch would.
    double merit() const
    {
        const Eigen::VectorXd misses = shell_.point_misses(task_.targets);
        return shell_.energy(bending_) + misses.squaredNorm();
    }

    Eigen::VectorXd shortened(const Eigen::VectorXd& change) const
    {
        const double shift = shell_.shift_of(change) / (longest_step * task_.size);
        const double turn = shell_.turn_of(change) / widest_turn;
        return change / std::max({1.0, shift, turn});
    }

    void accept()
    {
        energies_.push_back(merit());
        if (energies_.size() > remembered)
            energies_.pop_front();
    }

    //! \returns how far it moved the sheet, mm
    double step()
    {
        const ShellShape before = shell_.shape();
        const ShellSystem::Tangent tangent = shell_.tangent(bending_, &stresses_);
        if (const auto found = StepProblem(tangent, shell_, task_.targets).solve(0.0))
        {
            const Eigen::VectorXd change = shortened(*found);
            ShellSystem::Stresses next = shell_.predicted(bending_, change);
            const double shift = shell_.shift_of(change);
            const double highest = *std::max_element(energies_.begin(), energies_.end());
            shell_.step(change);
            if (merit() <= highest * (1.0 + 1e-9))
            {
                stresses_ = std::move(next);
                accept();
                return shift;
            }
            shell_.restore(before);
        }
        return tension_step();
    }

    double tension_step()
    {
        const ShellShape before = shell_.shape();
        const ShellSystem::Tangent tangent = shell_.tangent(bending_, nullptr);
        const StepProblem problem(tangent, shell_, task_.targets);
        std::optional<Eigen::VectorXd> found;
        for (double shift = 0.0; !found && shift < 1.0; shift = std::max(1e-10, 100.0 * shift))
            found = problem.solve(shift);
        if (!found)
            throw SolverError(
                "the sheet has no unique shape under these constraints; hold it by a fixed "
                "region, or choose another energy");
        Eigen::VectorXd change = shortened(*found);
        const double slope = tangent.gradient.dot(change);
        const double start = merit();
        for (int halving = 0; halving < 30; ++halving, change *= 0.5)
        {
            ShellSystem::Stresses next = shell_.predicted(bending_, change);
            const double shift = shell_.shift_of(change);
            shell_.step(change);
            if (merit() <= start + 1e-4 * std::ldexp(std::min(slope, 0.0), -halving))
            {
                stresses_ = std::move(next);
                accept();
                return shift;
            }
            shell_.restore(before);
        }
        return 0.0;
    }

    ShellSystem& shell_;
    const ShellTask& task_;
    double bending_;
    ShellSystem::Stresses stresses_;
    std::deque<double> energies_;
};

}  // namespace

Convergence minimise_shell(ShellSystem& shell, const ShellTask& task)
{
    const ShellShape start = shell.shape();
    Convergence found =
        Newton(shell, task, task.thickness).run(first_rounds, task.progress.part(0.0, 0.3));
    if (found.is_converged)
        return found;
    int rounds = found.rounds;
    shell.restore(start);
    double begin = 0.3;
    for (const double part : {10.0, 30.0})
    {
        if (task.size / part <= task.thickness)
            continue;
        const Progress progress = task.progress.part(begin, begin + 0.2);
        rounds += Newton(shell, task, task.size / part).run(ladder_rounds, progress).rounds;
        begin += 0.2;
    }
    found = Newton(shell, task, task.thickness).run(last_rounds, task.progress.part(begin, 1.0));
    found.rounds += rounds;
    return found;
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/steel/shell_minimum.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/numerics/newton_minimum.h"

#include <Eigen/QR>
#include <algorithm>
#include <memory>
#include <optional>

namespace sheetmorph::surface
{

using numerics::NewtonStep;

namespace
{

// Largest step at convergence, relative to the size: 0.1 micrometres of a part of 1 m. Chosen: far
// below any tolerance of sheet metal. Newton's method squares the error, so the last step leaves
// much less.
constexpr double settled = 1e-7;

// Bounds of a step: relative to the size, and radians for a body or a director. Chosen:
// second-order terms of a rotation w miss |w|^3 / 6, 0.09 radians at the bound. The other bound is
// about as far: a rotation by 0.5 about the middle moves an end by a quarter of the size.
constexpr double longest_step = 0.25;
constexpr double widest_turn = 0.8;

// Number of energies with which a step is compared: the nonmonotone rule of Grippo, Lampariello and
// Lucidi, 1986. Chosen: three steps may raise the energy on the way through a bent valley.
constexpr int remembered = 4;

// Relative to the energy. From rounding: a sum over 1e5 elements is exact to 1e5 * 1e-16 in the
// worst case, 1e-11, and usually to the root of that number, 3e-14.
constexpr double noise = 1e-12;

// Relative to the largest stress: tolerance of predicted stresses. Chosen: their tangent then
// differs from the true one by 0.1 %, so a step leaves a thousandth of the error; at convergence
// this is 1e-10 of the size.
constexpr double as_predicted = 1e-3;

// Smallest share of compression in a tangent. Chosen: halving 16 times; with less the tangent is
// that of tension alone, which is the next model.
constexpr double least_share = 1.0 / 65536.0;

// Relative to the size: after shorter steps of an eased tangent, the shape is probably at a saddle.
// Chosen: a tenth of the default thickness, smaller than every buckle that shows.
constexpr double near_saddle = 1e-3;

// Steps of inverse iteration. Chosen: a mode that is 10 % softer than the next one gains a factor
// of about 3 against it, and any mix of soft modes leads away from the saddle.
constexpr int buckling_rounds = 12;

// Bounds of the first step along a buckling mode: relative to the size, and radians. Chosen: twice
// the default thickness, so that stretching already resists the mode and Newton's method sees a
// convex energy; 0.2 radians (11 degrees) keep the mode linear to 2 %.
constexpr double first_buckle = 0.02;
constexpr double first_turn = 0.2;

// Chosen, not measured: a limit for poses that would not converge at all.
constexpr int most_rounds = 150;

//! The linear problem of one step with point constraints.
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

    //! Returns false if the tangent, with a share added to its diagonal, is not positive definite.
    bool factorise(numerics::SparseCholesky& factor, double shift) const
    {
        try
        {
            if (shift > 0.0)
                factor.factorise(shifted(shift));
            else
                factor.factorise(*tangent_.matrix);
            return true;
        }
        catch (const SolverError&)
        {
            return false;
        }
    }

    Eigen::VectorXd solve(const numerics::SparseCholesky& factor) const
    {
        if (misses_.size() == 0)
            return factor.solve(-tangent_.gradient);
        const Eigen::VectorXd right = -tangent_.gradient + weight_ * (rows_.transpose() * misses_);
        const Eigen::VectorXd open = factor.solve(right);
        const Eigen::MatrixXd responses =
            factor.solve(Eigen::MatrixXd(numerics::SparseMatrix(rows_.transpose())));
        const Eigen::MatrixXd schur = rows_ * responses;
        const Eigen::VectorXd multipliers =
            schur.completeOrthogonalDecomposition().solve(misses_ - rows_ * open);
        return open + responses * multipliers;
    }

private:
    // Adds weight * C^T C, which stiffens components supported only by points.
    void add_rows()
    {
        const numerics::SparseMatrix product = numerics::SparseMatrix(rows_.transpose()) * rows_;
        numerics::SparseMatrix& matrix = *tangent_.matrix;
        for (Eigen::Index column = 0; column < product.outerSize(); ++column)
            for (numerics::SparseMatrix::InnerIterator entry(product, column); entry; ++entry)
            {
                const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
                const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
                const int* found = std::lower_bound(begin, end, static_cast<int>(entry.row()));
                if (found != end && *found == entry.row())
                    matrix.valuePtr()[found - matrix.innerIndexPtr()] += weight_ * entry.value();
            }
    }

    numerics::SparseMatrix shifted(double shift) const
    {
        numerics::SparseMatrix matrix = *tangent_.matrix;
        for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
            for (numerics::SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
                if (entry.row() == column)
                    entry.valueRef() *= 1.0 + shift;
        return matrix;
    }

    const ShellSystem::Tangent& tangent_;
    const ShellSystem& shell_;
    Eigen::VectorXd misses_;
    numerics::SparseMatrix rows_;
    double weight_ = 0.0;
};

//! A shell for newton_minimum(). Step lengths are the largest displacement of a vertex, mm.
class ShellProblem : public numerics::NewtonProblem
{
public:
    ShellProblem(ShellSystem& shell, const ShellTask& task)
        : shell_(shell),
          task_(task),
          bending_(task.thickness * task.thickness / 12.0),
          before_(shell.shape()),
          stresses_(shell.no_stresses()),
          factor_(pattern_of(shell))
    {
    }

    // Adds the squared error of the points, in the same unit as the energy of the sheet (mm^2).
    double value() override
    {
        const Eigen::VectorXd misses = shell_.point_misses(task_.targets);
        return shell_.energy(bending_) + misses.squaredNorm();
    }

    std::optional<NewtonStep> step(int model) override
    {
        if (model == 0)
            return mixed_step();
        return model == 1 ? eased_step() : tension_step();
    }

    void remember() override
    {
        before_ = shell_.shape();
        last_ = stresses_;
    }
    void restore() override
    {
        shell_.restore(before_);
        stresses_ = last_;
    }
    void move(const NewtonStep& step, double share) override
    {
        const Eigen::VectorXd change = share * step.change;
        shell_.restore(before_);
        stresses_ = shell_.predicted(bending_, change);
        shell_.step(change);
    }

private:
    static std::shared_ptr<const numerics::FrontPattern> pattern_of(const ShellSystem& shell)
    {
        return std::make_shared<const numerics::FrontPattern>(
            numerics::Elimination(numerics::unmerged(shell.pattern()), shell.tree()));
    }

    std::optional<NewtonStep> mixed_step()
    {
        const ShellSystem::Tangent tangent = shell_.tangent(bending_, stresses_);
        const StepProblem problem(tangent, shell_, task_.targets);
        if (!problem.factorise(factor_, 0.0))
            return std::nullopt;
        NewtonStep found = bounded(tangent.gradient, problem.solve(factor_));
        found.is_exact = are_true(stresses_);
        return found;
    }

    // Uses the largest share of compression for which the tangent is positive definite.
    std::optional<NewtonStep> eased_step()
    {
        for (double share = std::min(1.0, 4.0 * share_); share >= least_share; share *= 0.5)
        {
            const ShellSystem::Tangent tangent =
                shell_.tangent(bending_, shell_.eased(bending_, share), share);
            const StepProblem problem(tangent, shell_, task_.targets);
            if (!problem.factorise(factor_, 0.0))
                continue;
            share_ = share;
            NewtonStep found = bounded(tangent.gradient, problem.solve(factor_));
            found.is_exact = share == 1.0;
            if (!found.is_exact && found.length <= near_saddle * task_.size)
                if (const auto buckling = buckling_step(tangent.gradient, share))
                    return buckling;
            return found;
        }
        share_ = least_share;
        return std::nullopt;
    }

    // Near a saddle: the first buckling mode, on the side of decreasing energy. Inverse iteration
    // uses the available factor of the eased tangent K + share (H - K), with the full tangent H and
    // the tangent K of tension alone. Its largest eigenvalue relative to K is 1 / (1 - share mu),
    // where H = (1 - mu) K.
    std::optional<NewtonStep> buckling_step(const Eigen::VectorXd& gradient, double share)
    {
        const ShellSystem::Tangent tension =
            shell_.tangent(bending_, shell_.eased(bending_, 0.0), 0.0);
        const StepProblem held(tension, shell_, task_.targets);
        Eigen::VectorXd mode = shell_.out_of_plane();
        double largest = 0.0;
        for (int k = 0; k < buckling_rounds; ++k)
        {
            look_for_stop();
            const Eigen::VectorXd load = *tension.matrix * mode;
            const double energy = mode.dot(load);
            if (!(energy > 0.0))
                return std::nullopt;
            const Eigen::VectorXd next = factor_.solve(load);
            largest = load.dot(next) / energy;
            mode = next / next.norm();
        }
        if (!(largest * (1.0 - share) > 1.0))
            return std::nullopt;
        if (gradient.dot(mode) > 0.0)
            mode = -mode;
        const double amplitude = std::min(first_buckle * task_.size / shell_.shift_of(mode),
                                          first_turn / shell_.turn_of(mode));
        NewtonStep found = bounded(gradient, amplitude * mode);
        found.is_exact = false;
        return found;
    }

    std::optional<NewtonStep> tension_step()
    {
        const ShellSystem::Tangent tangent =
            shell_.tangent(bending_, shell_.eased(bending_, 0.0), 0.0);
        const StepProblem problem(tangent, shell_, task_.targets);
        bool is_factorised = false;
        // Chosen: from a shift that only rounding needs (1e-10) in steps of 100 to a hundredth of
        // the diagonal.
        for (double shift = 0.0; !is_factorised && shift < 1.0;
             shift = std::max(1e-10, 100.0 * shift))
            is_factorised = problem.factorise(factor_, shift);
        if (!is_factorised)
            throw SolverError("the sheet has no unique shape under these constraints",
                              "mark a fixed region on it, or choose another energy");
        NewtonStep found = bounded(tangent.gradient, problem.solve(factor_));
        found.is_exact = false;
        return found;
    }

    NewtonStep bounded(const Eigen::VectorXd& gradient, const Eigen::VectorXd& change) const
    {
        NewtonStep found;
        found.length = shell_.shift_of(change);
        const double turn = shell_.turn_of(change);
        const double bound =
            std::max({1.0, found.length / (longest_step * task_.size), turn / widest_turn});
        found.change = change / bound;
        found.slope = gradient.dot(found.change);
        found.is_bounded = bound > 1.0;
        return found;
    }

    // Whether predicted stresses are those of the shape, so that their tangent is the second-order
    // model there.
    bool are_true(const ShellSystem::Stresses& stresses) const
    {
        const ShellSystem::Stresses now = shell_.eased(bending_, 1.0);
        double membrane = 0.0, moments = 0.0, off_membrane = 0.0, off_moments = 0.0;
        for (std::size_t e = 0; e < now.size(); ++e)
        {
            membrane = std::max(membrane, now[e].membrane.cwiseAbs().maxCoeff());
            moments = std::max(moments, now[e].moments.cwiseAbs().maxCoeff());
            off_membrane = std::max(off_membrane,
                                    (stresses[e].membrane - now[e].membrane).cwiseAbs().maxCoeff());
            off_moments =
                std::max(off_moments, (stresses[e].moments - now[e].moments).cwiseAbs().maxCoeff());
        }
        return off_membrane <= as_predicted * membrane && off_moments <= as_predicted * moments;
    }

    ShellSystem& shell_;
    const ShellTask& task_;
    double bending_;
    ShellShape before_;
    ShellSystem::Stresses stresses_, last_;
    double share_ = 1.0;               // share of compression in the last eased step
    numerics::SparseCholesky factor_;  // of the last tangent
};

}  // namespace

Convergence minimise_shell(ShellSystem& shell, const ShellTask& task)
{
    numerics::NewtonLimits limits{"the positions of the sheet"};
    limits.most_rounds = most_rounds;
    limits.settled = settled * task.size;
    limits.finest = limits.settled;
    limits.models = 3;
    limits.remembered = remembered;
    limits.noise = noise;
    limits.task = "steel";
    ShellProblem problem(shell, task);
    return numerics::newton_minimum(problem, limits, task.progress);
}

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/reduced_minimum.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"
#include "sheetmorph/surface/solve/reduced_expansion.h"

#include <Eigen/Eigenvalues>
#include <limits>
#include <optional>

namespace sheetmorph
{

namespace
{

constexpr int none = -1;
constexpr int most_steps = 100;
constexpr double smallest_step = 1e-14;  // radians, or of the size of the feature
constexpr double largest_squared = 0.1;  // radians, and of the step before: Newton squares these
constexpr double left_by_a_step = 10.0;  // of its square, at most
constexpr double rounding = 1e-9;        // steps below it that shrink no more are noise
constexpr double unseen_gain = 1e-10;    // of the energy: what rounding hides
constexpr double unfelt = 1e-11;         // of the stiffest freedom: the energy does not feel it
constexpr double barely_convex = 1e-6;   // likewise: what this makes convex some do not feel
constexpr double first_shift = 0.02;     // likewise, where the energy is not convex
constexpr double left_by_rounds = 0.03;  // of its square: rounds leave less than the step itself
constexpr double lowest_share = 1e-9;    // of the step: what rounding leaves of it
constexpr int most_rounds = 60;          // of conjugate gradients

// Numbers that make every freedom about as stiff as any other; what nothing feels gets none.
Eigen::VectorXd scales(const Expansion& at)
{
    const Eigen::VectorXd stiff = at.hessian.diagonal().cwiseAbs();
    const double largest = stiff.size() > 0 ? stiff.maxCoeff() : 0.0;
    return stiff.unaryExpr(
        [largest](double value)
        { return value > 1e-18 * largest && value > 0.0 ? 1.0 / std::sqrt(value) : 0.0; });
}

// Whether what is left after a step is as good as nothing: it is small, or squares so fast that the
// next would be.
bool is_last(double step, double before, double precision)
{
    const double squared = step * (step / before) * (step / before);
    return step <= std::max(precision, smallest_step)
           || (before < largest_squared && step < largest_squared * before
               && squared <= std::max(left_by_a_step * precision * precision, smallest_step));
}

// Factor of a symmetric matrix + shift; nothing where a pivot is not positive, or as good as none.
std::optional<DenseCholesky> factored(const Eigen::MatrixXd& matrix, double shift)
{
    Weights shifted = matrix.transpose();  // as it lies in memory
    shifted.diagonal().array() += shift;
    try
    {
        const DenseCholesky factor(std::move(shifted));
        if (factor.smallest_pivot() > std::sqrt(unfelt))
            return factor;
    }
    catch (const SolverError&)
    {
        // Not positive definite.
    }
    return std::nullopt;
}

// Of what some freedoms do not feel: along eigenvectors, with |eigenvalue|.
Eigen::VectorXd eigen_step(const Eigen::MatrixXd& scaled, const Eigen::VectorXd& right)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
    const Eigen::VectorXd values = eigen.eigenvalues().cwiseAbs();
    const double largest = values.maxCoeff();
    const Eigen::VectorXd inverse = values.unaryExpr(
        [largest](double value) { return value > unfelt * largest ? 1.0 / value : 0.0; });
    const Eigen::VectorXd along = eigen.eigenvectors().transpose() * right;
    return eigen.eigenvectors() * inverse.cwiseProduct(along);
}

// No freedom turns or shifts by more than a quarter of a radian of its own scale at once.
double shortened(const Eigen::VectorXd& step, const Joints& joints)
{
    double turn = 0.0;
    for (std::size_t k = 0; k < joints.states().size(); ++k)
        for (const JointLevel& level : joints.levels(k))
            if (level.is_turn)
                turn = std::max(
                    turn, step.segment(level.first, static_cast<Eigen::Index>(level.axes.size()))
                              .cwiseAbs()
                              .maxCoeff());
    return turn > 0.8 ? 0.8 / turn : 1.0;
}

// Newton's step by conjugate gradients, so near that what is left of it is less than what it
// leaves; nothing where the energy is not convex, or so far from how it is at rest that this takes
// long.
std::optional<Eigen::VectorXd> near_step(const TurnExpansion& at, double precision)
{
    Eigen::VectorXd step = Eigen::VectorXd::Zero(at.gradient().size());
    Eigen::VectorXd left = -at.gradient(), near = at.nearly_solved(left), direction = near;
    double share = left.dot(near);
    const double first = near.cwiseAbs().maxCoeff();
    const double enough = std::max({left_by_rounds * first * first, lowest_share * first,
                                    left_by_rounds * precision * precision});
    for (int round = 0; round < most_rounds; ++round)
    {
        if (near.cwiseAbs().maxCoeff() <= enough)
            return step;
        const Eigen::VectorXd product = at.times(direction);
        const double curvature = direction.dot(product);
        if (!(curvature > 0.0))
            return std::nullopt;
        step += share / curvature * direction;
        left -= share / curvature * product;
        near = at.nearly_solved(left);
        const double before = share;
        share = left.dot(near);
        direction = near + share / before * direction;
    }
    return std::nullopt;
}

//! A step, and what the energy changes by along it, per unit.
struct Step
{
    Eigen::VectorXd amount;
    double slope;
};

Step next_step(const Joints& joints, const Measure& measure, const Forces& here, double precision)
{
    if (TurnExpansion::is_possible(joints, measure.responses))
    {
        const TurnExpansion at(joints, measure, here);
        if (const std::optional<Eigen::VectorXd> step = near_step(at, precision))
            return {*step, at.gradient().dot(*step)};
    }
    const Expansion at = expand(joints, measure, here);
    const Eigen::VectorXd step = newton_step(at);
    return {step, at.gradient.dot(step)};
}

}  // namespace

Eigen::VectorXd newton_step(const Expansion& at)
{
    const Eigen::VectorXd scale = scales(at);
    const Eigen::MatrixXd scaled = scale.asDiagonal() * at.hessian * scale.asDiagonal();
    const Eigen::VectorXd right = -(scale.asDiagonal() * at.gradient);
    std::optional<DenseCholesky> factor = factored(scaled, 0.0);
    if (!factor && !factored(scaled, barely_convex))
        for (double shift = first_shift; !factor && shift < 100.0; shift *= 4.0)
            factor = factored(scaled, shift);
    if (!factor)
        return scale.asDiagonal() * eigen_step(scaled, right);
    return scale.asDiagonal() * factor->solve(right);
}

Eigen::MatrixXd entries_of(const Joints& joints, const PlacementInput& part,
                           const FeatureResponses& responses)
{
    const std::vector<TurnerColumns>& columns = responses.columns();
    int rows = 0;
    for (const TurnerColumns& of_turner : columns)
        rows += (of_turner.turn != none ? 3 : 0) + (of_turner.shift != none ? 1 : 0);
    Eigen::MatrixXd entries = Eigen::MatrixXd::Zero(rows, 3);
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
        const BodyState& state = joints.states()[k];
        if (columns[k].turn != none)
            entries.block<3, 3>(columns[k].turn, 0) =
                (state.rotation - Matrix3::Identity()).transpose();
        if (columns[k].shift != none)
        {
            const int body = responses.turners()[k].body;
            const Vector3& rest = part.roles.bodies[static_cast<std::size_t>(body)].centre;
            entries.row(columns[k].shift) = (state.centre - rest).transpose();
        }
    }
    return entries;
}

Convergence minimise(Joints& joints, const Measure& measure, double precision)
{
    Convergence found{"the turns of form features", joints.freedoms() == 0, 0, 0.0, "radians"};
    double last = std::numeric_limits<double>::infinity();
    Forces here = forces_at(joints, measure);
    for (; found.rounds < most_steps && !found.is_converged; ++found.rounds)
    {
        auto [step, slope] = next_step(joints, measure, here, precision);
        const double shorter = shortened(step, joints), gain = std::abs(shorter * slope);
        step *= shorter;
        const double noise = 1e-14 * std::abs(here.value);
        const std::vector<BodyState> start = joints.states();
        std::optional<Forces> lower;
        for (int halving = 0; halving < 40 && !lower; ++halving, step *= 0.5)
        {
            joints.restore(start);
            joints.step(step);
            Forces there = forces_at(joints, measure);
            if (there.value <= here.value + noise)
                lower = std::move(there);
        }
        found.miss = step.cwiseAbs().maxCoeff();
        if (!lower)
        {
            // No step is lower: at the minimum, but for the rounding of what there is to gain.
            joints.restore(start);
            found.is_converged = gain <= unseen_gain * std::abs(here.value);
            return found;
        }
        here = std::move(*lower);
        found.is_converged =
            is_last(found.miss, last, precision) || (last < rounding && found.miss > 0.5 * last);
        last = found.miss;
    }
    return found;
}

}  // namespace sheetmorph

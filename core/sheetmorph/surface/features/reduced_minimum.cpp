// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/features/reduced_minimum.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"
#include "sheetmorph/numerics/newton_minimum.h"
#include "sheetmorph/surface/features/reduced_expansion.h"

#include <Eigen/Eigenvalues>
#include <optional>
#include <utility>

namespace sheetmorph::surface
{

namespace
{

constexpr int none = -1;
// Measured with a prototype on a strip with three holes: Newton takes 4 to 12 steps. Chosen far
// above.
constexpr int most_steps = 100;

// Radians, or relative to the size of the feature. From rounding of a rotation: 50 units of 2e-16.
constexpr double smallest_step = 1e-14;

// Radians; below it convergence is quadratic. From the Taylor series of a rotation w: the
// third-order term is |w|^3 / 6, a sixth of a percent of |w| at 0.1.
constexpr double largest_squared = 0.1;

// Limit of the error after a step, relative to its square. Chosen: the series alone gives 1/2; soft
// freedoms enlarge it.
constexpr double left_by_a_step = 10.0;

// Radians; shorter steps that do not shrink are noise. From the accuracy that SheetMorph promises,
// 1e-9 of the size.
constexpr double settled = 1e-9;

// Relative to the energy; a smaller gain is lost in rounding. Chosen: energies are differences of
// sums over the sheet, which keep ten digits.
constexpr double unseen_gain = 1e-10;

// Radians per step. From the Taylor series: the quadratic model misses |w|^3 / 6, 0.09 at 0.8.
constexpr double widest_turn = 0.8;

// Relative to the stiffest freedom; less has no effect. From rounding: entries of the Hessian are
// exact to 1e-16 times a condition of the sheet of 1e5.
constexpr double unfelt = 1e-11;

// Likewise; a Hessian that this shift makes convex is singular. Chosen: far above unfelt, and so
// small that a true negative curvature exceeds it.
constexpr double barely_convex = 1e-6;

// Likewise; first shift of an indefinite Hessian. Chosen: it grows fourfold per attempt, so seven
// attempts reach 100, which makes any scaled Hessian convex.
constexpr double first_shift = 0.02;

// Relative to the step squared: error that conjugate gradients leave. Chosen: below Newton's own
// error, of the order of the square.
constexpr double left_by_rounds = 0.03;

// Relative to the step: rounding limits the error of conjugate gradients. From the condition of the
// Hessian, below 1e7 near rest.
constexpr double lowest_share = 1e-9;

// Chosen: with more rounds, a dense factor is faster.
constexpr int most_rounds = 60;

// Scales that give all freedoms a similar stiffness; 0 for freedoms without stiffness.
Eigen::VectorXd scales(const Expansion& at)
{
    const Eigen::VectorXd stiff = at.hessian.diagonal().cwiseAbs();
    const double largest = stiff.size() > 0 ? stiff.maxCoeff() : 0.0;
    return stiff.unaryExpr(
        [largest](double value)
        // From doubles: a hundredth of the rounding of the largest stiffness.
        { return value > 1e-18 * largest && value > 0.0 ? 1.0 / std::sqrt(value) : 0.0; });
}

// Factor of a symmetric matrix plus shift; nothing if a pivot is not clearly positive.
std::optional<numerics::DenseCholesky> factored(const Eigen::MatrixXd& matrix, double shift)
{
    numerics::Weights shifted = matrix.transpose();  // same memory layout
    shifted.diagonal().array() += shift;
    try
    {
        const numerics::DenseCholesky factor(std::move(shifted));
        if (factor.smallest_pivot() > std::sqrt(unfelt))
            return factor;
    }
    catch (const SolverError&)
    {
        // Not positive definite.
    }
    return std::nullopt;
}

// Step with |eigenvalues| along eigenvectors, for Hessians that are singular in some freedoms.
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

// The largest share of a step for which every rotation stays within the model's range.
double bound_of(const Eigen::VectorXd& step, const Joints& joints)
{
    double turn = 0.0;
    for (std::size_t k = 0; k < joints.states().size(); ++k)
        for (const JointLevel& level : joints.levels(k))
            if (level.is_turn)
                turn = std::max(
                    turn, step.segment(level.first, static_cast<Eigen::Index>(level.axes.size()))
                              .cwiseAbs()
                              .maxCoeff());
    return turn > widest_turn ? widest_turn / turn : 1.0;
}

// Newton's step by conjugate gradients, until the remaining error is smaller than Newton's own.
// Nothing if the energy is not convex, or if convergence is slow because the state is far from
// rest.
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

//! A step, and whether its Hessian has no negative direction.
struct ConvexStep
{
    Eigen::VectorXd amount;
    bool is_convex;
};

ConvexStep convex_step(const Expansion& at)
{
    const Eigen::VectorXd scale = scales(at);
    const Eigen::MatrixXd scaled = scale.asDiagonal() * at.hessian * scale.asDiagonal();
    const Eigen::VectorXd right = -(scale.asDiagonal() * at.gradient);
    std::optional<numerics::DenseCholesky> factor = factored(scaled, 0.0);
    const bool is_convex = factor || factored(scaled, barely_convex);
    if (!is_convex)
        for (double shift = first_shift; !factor && shift < 100.0; shift *= 4.0)
            factor = factored(scaled, shift);
    if (!factor)
        return {scale.asDiagonal() * eigen_step(scaled, right), is_convex};
    return {scale.asDiagonal() * factor->solve(right), is_convex};
}

//! The energy of the joints for newton_minimum(). Step lengths are the largest component, radians.
class JointProblem : public numerics::NewtonProblem
{
public:
    JointProblem(Joints& joints, const Measure& measure, double precision)
        : joints_(joints),
          measure_(measure),
          precision_(precision),
          here_(forces_at(joints, measure)),
          before_{joints.states(), here_}
    {
    }

    double value() override { return here_.value; }

    std::optional<numerics::NewtonStep> step(int) override
    {
        if (TurnExpansion::is_possible(joints_, measure_.responses))
        {
            const TurnExpansion at(joints_, measure_, here_);
            if (const std::optional<Eigen::VectorXd> step = near_step(at, precision_))
                return bounded({*step, true}, at.gradient());
        }
        const Expansion at = expand(joints_, measure_, here_);
        return bounded(convex_step(at), at.gradient);
    }

    void remember() override { before_ = {joints_.states(), here_}; }
    void restore() override
    {
        joints_.restore(before_.first);
        here_ = before_.second;
    }
    void move(const numerics::NewtonStep& step, double share) override
    {
        joints_.restore(before_.first);
        joints_.step(share * step.change);
        here_ = forces_at(joints_, measure_);
    }

private:
    numerics::NewtonStep bounded(const ConvexStep& step, const Eigen::VectorXd& gradient) const
    {
        const double bound = bound_of(step.amount, joints_);
        numerics::NewtonStep found{bound * step.amount};
        found.length = step.amount.size() > 0 ? step.amount.cwiseAbs().maxCoeff() : 0.0;
        found.slope = gradient.dot(found.change);
        found.is_bounded = bound < 1.0;
        found.is_exact = step.is_convex;
        return found;
    }

    Joints& joints_;
    const Measure& measure_;
    double precision_;
    Forces here_;
    std::pair<std::vector<BodyState>, Forces> before_;
};

}  // namespace

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
    numerics::NewtonLimits limits{"the rotations of form features", "radians"};
    if (joints.freedoms() == 0)
        return {limits.what, true, 0, 0.0, limits.unit};
    limits.most_rounds = most_steps;
    limits.settled = std::max(precision, settled);
    limits.finest = std::max(precision, smallest_step);
    limits.squares_below = largest_squared;
    limits.left = std::max(left_by_a_step * precision * precision, smallest_step);
    limits.unseen_gain = unseen_gain;
    JointProblem problem(joints, measure, precision);
    return numerics::newton_minimum(problem, limits);
}

}  // namespace sheetmorph::surface

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/newton_minimum.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::numerics
{
namespace
{

using Eigen::MatrixXd;
using Eigen::VectorXd;

//! A function of two numbers with its derivatives, and what a test breaks in it.
struct Valley : NewtonProblem
{
    std::function<double(const VectorXd&)> of;
    std::function<VectorXd(const VectorXd&)> gradient;
    std::function<MatrixXd(const VectorXd&)> hessian;
    VectorXd place = VectorXd::Zero(2), before = VectorXd::Zero(2);
    double bound = 1e300;  //!< of a step
    bool has_convex_model = true;
    bool is_uphill = false;

    double value() override { return of(place); }
    std::optional<NewtonStep> step(int model) override
    {
        MatrixXd matrix = hessian(place);
        if (model == 1)
            matrix =
                MatrixXd::Identity(2, 2) * (1.0 + matrix.cwiseAbs().rowwise().sum().maxCoeff());
        const Eigen::LLT<MatrixXd> factor(matrix);
        if (factor.info() != Eigen::Success || (model == 1 && !has_convex_model))
            return std::nullopt;
        NewtonStep found{-factor.solve(gradient(place))};
        if (is_uphill)
            found.change *= -1.0;
        found.length = found.change.norm();
        found.is_bounded = found.length > bound;
        found.change *= std::min(1.0, bound / found.length);
        found.slope = gradient(place).dot(found.change);
        found.is_exact = model == 0;
        return found;
    }
    void remember() override { before = place; }
    void restore() override { place = before; }
    void move(const NewtonStep& step, double share) override
    {
        place = before + share * step.change;
    }
};

// Rosenbrock's valley: minimum 0 at (1, 1).
Valley banana()
{
    Valley made;
    made.of = [](const VectorXd& x)
    { return std::pow(1.0 - x(0), 2) + 100.0 * std::pow(x(1) - x(0) * x(0), 2); };
    made.gradient = [](const VectorXd& x)
    {
        const double off = x(1) - x(0) * x(0);
        return VectorXd(Eigen::Vector2d(-2.0 * (1.0 - x(0)) - 400.0 * x(0) * off, 200.0 * off));
    };
    made.hessian = [](const VectorXd& x)
    {
        Eigen::Matrix2d matrix;
        matrix << 2.0 - 400.0 * x(1) + 1200.0 * x(0) * x(0), -400.0 * x(0), -400.0 * x(0), 200.0;
        return MatrixXd(matrix);
    };
    return made;
}

// x^2 - y^2 + y^4: a saddle at the origin, minima at y = +-1/sqrt(2).
Valley saddle()
{
    Valley made;
    made.of = [](const VectorXd& x) { return x(0) * x(0) - x(1) * x(1) + std::pow(x(1), 4); };
    made.gradient = [](const VectorXd& x)
    { return VectorXd(Eigen::Vector2d(2.0 * x(0), -2.0 * x(1) + 4.0 * std::pow(x(1), 3))); };
    made.hessian = [](const VectorXd& x)
    { return MatrixXd(Eigen::Vector2d(2.0, -2.0 + 12.0 * x(1) * x(1)).asDiagonal()); };
    return made;
}

NewtonLimits limits(int rounds = 200)
{
    NewtonLimits found{"the place"};
    found.most_rounds = rounds;
    found.settled = found.finest = 1e-8;
    found.models = 2;
    return found;
}

TEST(NewtonMinimum, FindsTheMinimumFromAnywhere)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    for (int k = 0; k < 50; ++k)
        for (Valley problem : {banana(), saddle()})
        {
            problem.place << number(random), number(random);
            problem.bound = k % 2 == 0 ? 1e300 : 0.3;
            const Convergence found = newton_minimum(problem, limits(2000));
            ASSERT_TRUE(found.is_converged) << problem.before.transpose();
            EXPECT_LT(problem.gradient(problem.place).norm(), 1e-5);
            EXPECT_EQ(Eigen::LLT<MatrixXd>(problem.hessian(problem.place)).info(), Eigen::Success);
        }
}

TEST(NewtonMinimum, WhatClaimsToHaveConvergedIsStationaryHoweverFewRoundsItHad)
{
    for (int rounds = 0; rounds < 40; ++rounds)
    {
        Valley problem = banana();
        problem.place << -1.2, 1.0;
        problem.bound = 0.4;
        if (newton_minimum(problem, limits(rounds)).is_converged)
            EXPECT_LT(problem.gradient(problem.place).norm(), 1e-5) << rounds;
        else
            EXPECT_LT(rounds, 30);
    }
}

TEST(NewtonMinimum, ASaddleIsNotAMinimum)
{
    Valley problem = saddle();  // starts at it: the convex model's step is 0
    EXPECT_FALSE(newton_minimum(problem, limits()).is_converged);
}

TEST(NewtonMinimum, AStepThatTheLineSearchShortensToNothingHasNotConverged)
{
    // The gradient points the wrong way, so every step rises however short it is.
    Valley problem = banana();
    problem.place << -1.2, 1.0;
    problem.is_uphill = true;
    const Convergence found = newton_minimum(problem, limits());
    EXPECT_FALSE(found.is_converged);
    EXPECT_EQ(problem.place, VectorXd(Eigen::Vector2d(-1.2, 1.0)));
    EXPECT_FALSE(found.sentence().empty());
}

TEST(NewtonMinimum, AValueThatIsNowhereLowerHasNotConverged)
{
    Valley problem = banana();
    problem.place << -1.2, 1.0;
    const VectorXd start = problem.place;
    const auto valley = problem.of;
    problem.of = [&](const VectorXd& x)
    { return x == start ? valley(x) : std::numeric_limits<double>::quiet_NaN(); };
    EXPECT_FALSE(newton_minimum(problem, limits()).is_converged);
    EXPECT_EQ(problem.place, start);
}

TEST(NewtonMinimum, FactorisationsThatFailHaveNotConverged)
{
    Valley problem = saddle();
    problem.has_convex_model = false;
    const Convergence found = newton_minimum(problem, limits());
    EXPECT_FALSE(found.is_converged);
    EXPECT_EQ(found.rounds, 1);
}

TEST(NewtonMinimum, AStepThatABoundMakesShortHasNotConverged)
{
    Valley problem = banana();
    problem.place << -1.2, 1.0;
    problem.bound = 1e-9;  // shorter than what counts as settled
    EXPECT_FALSE(newton_minimum(problem, limits()).is_converged);
}

TEST(NewtonMinimum, RoundingAtTheMinimumIsNoFailure)
{
    // Noise of 1e-9 in the value: no step can be seen to lower it.
    Valley problem = banana();
    problem.place << 1.0 + 1e-7, 1.0;
    int calls = 0;
    problem.of = [&calls](const VectorXd&) { return 1.0 + 1e-9 * ++calls; };
    NewtonLimits few = limits();
    few.unseen_gain = 1e-9;
    EXPECT_TRUE(newton_minimum(problem, few).is_converged);
}

}  // namespace
}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/constrained_minimiser.h"

#include "numerics/cholesky/cholmod_oracle.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace sheetmorph::numerics
{
namespace
{

SparseMatrix sparse(const Eigen::MatrixXd& dense)
{
    return dense.sparseView();
}

// Twelve unknown values of which three are known and two are tied together.
struct Small
{
    Eigen::MatrixXd rows = Eigen::MatrixXd::Random(15, 12);
    Eigen::VectorXd weights = Eigen::VectorXd::Random(15).cwiseAbs() + Eigen::VectorXd::Ones(15);
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(12, 8);
    Eigen::MatrixXd constraints = Eigen::MatrixXd::Random(2, 12);
    ConstrainedMinimiser::Targets targets{Eigen::MatrixXd::Random(15, 3),
                                          Eigen::MatrixXd::Zero(12, 3),
                                          Eigen::MatrixXd::Random(2, 3)};

    Small()
    {
        for (int i = 0; i < 9; ++i)
            basis(i, std::min(i, 7)) = 1.0;
        targets.offset.bottomRows(3) = Eigen::MatrixXd::Random(3, 3);
    }

    QuadraticProblem problem() const
    {
        return {sparse(rows), weights, sparse(basis), sparse(constraints),
                {},           nullptr, one_node(12)};
    }

    // The same minimum from the dense KKT system.
    Eigen::MatrixXd kkt() const
    {
        const Eigen::MatrixXd reduced = rows * basis;
        const Eigen::MatrixXd g = constraints * basis;
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(10, 10);
        system.topLeftCorner(8, 8) = reduced.transpose() * weights.asDiagonal() * reduced;
        system.topRightCorner(8, 2) = g.transpose();
        system.bottomLeftCorner(2, 8) = g;
        Eigen::MatrixXd side(10, 3);
        side.topRows(8) =
            reduced.transpose() * weights.asDiagonal() * (targets.rows - rows * targets.offset);
        side.bottomRows(2) = targets.constraints - constraints * targets.offset;
        return targets.offset + basis * system.fullPivLu().solve(side).topRows(8);
    }
};

TEST(ConstrainedMinimiser, AgreesWithTheDenseKktSystem)
{
    const Small small;
    const ConstrainedMinimiser minimiser(small.problem());
    const Eigen::MatrixXd u = minimiser.solve(small.targets, 1);
    EXPECT_LT((u - small.kkt()).norm(), 1e-10);
    EXPECT_LT(minimiser.constraint_error(u, small.targets.constraints).maxCoeff(), 1e-12);
}

TEST(ConstrainedMinimiser, ASupportingConstraintDoesNotChangeTheMinimum)
{
    const Small small;
    QuadraticProblem problem = small.problem();
    problem.supporting = {1};
    EXPECT_LT((ConstrainedMinimiser(problem).solve(small.targets, 1) - small.kkt()).norm(), 1e-10);
}

// A refinement would hide a mistake in the first solution.
TEST(ConstrainedMinimiser, TheFirstSolutionIsTheMinimumAlready)
{
    const Small small;
    for (const std::vector<int>& supporting : {std::vector<int>{}, std::vector<int>{1}})
    {
        QuadraticProblem problem = small.problem();
        problem.supporting = supporting;
        const Eigen::MatrixXd u = ConstrainedMinimiser(problem).solve(small.targets, 0);
        EXPECT_LT((u - small.kkt()).norm(), 1e-9) << supporting.size();
    }
}

// Also the multipliers of a supporting constraint, whose weight is in the factor.
TEST(ConstrainedMinimiser, MultipliersAndResidualsAreInBalanceHoweverOftenTheyAreRefined)
{
    const Small small;
    for (const std::vector<int>& supporting : {std::vector<int>{}, std::vector<int>{1}})
    {
        QuadraticProblem problem = small.problem();
        problem.supporting = supporting;
        const ConstrainedMinimiser minimiser(problem);
        for (const int refinements : {0, 1, 4})
        {
            const auto found = minimiser.minimum(small.targets, refinements);
            const auto left = minimiser.balance(small.targets, found);
            EXPECT_LT((small.basis.transpose() * left.forces).norm(), 1e-9) << refinements;
        }
    }
}

// With and without constraints that are redundant, and one that supports the part.
TEST(ConstrainedMinimiser, EnergiesOfSparseTargetsAreThoseOfTheirMinima)
{
    for (const int constraints : {0, 1, 2})
        for (const std::vector<int>& supporting : {std::vector<int>{}, std::vector<int>{0}})
        {
            Small small;
            small.constraints.row(1) = 2.0 * small.constraints.row(0);
            small.constraints.conservativeResize(constraints, Eigen::NoChange);
            QuadraticProblem problem = small.problem();
            problem.supporting = constraints > 0 ? supporting : std::vector<int>{};
            const ConstrainedMinimiser minimiser(problem);
            small.targets.constraints = Eigen::MatrixXd::Zero(constraints, 3);
            const Eigen::MatrixXd left =
                small.rows * minimiser.solve(small.targets, 2) - small.targets.rows;
            const Eigen::MatrixXd expected = left.transpose() * small.weights.asDiagonal() * left;
            const Eigen::MatrixXd found =
                minimiser.energies(sparse(small.targets.rows), sparse(small.targets.offset));
            EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-10) << constraints;
        }
}

TEST(ConstrainedMinimiser, TellsWhichConstraintCannotBeMet)
{
    Small small;
    small.constraints.row(1) = 2.0 * small.constraints.row(0);
    const ConstrainedMinimiser minimiser(small.problem());
    small.targets.constraints.row(1) = 2.0 * small.targets.constraints.row(0);
    const Eigen::MatrixXd met = minimiser.solve(small.targets, 1);
    EXPECT_LT(minimiser.constraint_error(met, small.targets.constraints).maxCoeff(), 1e-10);
    small.targets.constraints(1, 2) += 1.0;
    const Eigen::MatrixXd torn = minimiser.solve(small.targets, 1);
    EXPECT_GT(minimiser.constraint_error(torn, small.targets.constraints).maxCoeff(), 0.1);
}

}  // namespace
}  // namespace sheetmorph::numerics

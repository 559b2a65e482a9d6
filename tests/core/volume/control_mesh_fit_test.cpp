// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/control_mesh_fit.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/volume/control_mesh.h"
#include "sheetmorph/volume/mean_value_coordinates.h"
#include "shapes.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace sheetmorph::volume
{

using namespace numerics;

namespace
{

class ControlMeshFitTest : public testing::Test
{
protected:
    ControlShape shape_{2};
    Points samples_ =
        shapes::grid(6, 4, 1.6, 1.0).points().rowwise() - Eigen::RowVector3d(0.8, 0.5, 0);
    Weights weights_ =
        MeanValueCoordinates(shape_.vertices(), shape_.triangles()).weights(samples_);
    Eigen::VectorXd areas_ = Eigen::VectorXd::LinSpaced(samples_.rows(), 1.0, 2.0);
    ControlMeshFit fit_{weights_, areas_, shape_.laplacian(), 0.05};
};

Points waves(const Points& points)
{
    Points result(points.rows(), 3);
    result.col(0) = points.col(1).array().sin();
    result.col(1) = points.col(0).array().square();
    result.col(2) = (3.0 * points.col(0)).array().cos();
    return result;
}

TEST_F(ControlMeshFitTest, ZeroStaysZeroExactly)
{
    EXPECT_TRUE(fit_.displacements(Points::Zero(samples_.rows(), 3)).isZero(0.0));
}

TEST_F(ControlMeshFitTest, AShiftOfTheSamplesShiftsTheControlMesh)
{
    const Eigen::RowVector3d shift(1.0, -2.0, 3.0);
    const Points found = fit_.displacements(shift.replicate(samples_.rows(), 1));
    EXPECT_LT((found.rowwise() - shift).cwiseAbs().maxCoeff(), 1e-10);
}

TEST_F(ControlMeshFitTest, IsTheMinimumOfTheEnergy)
{
    const Points wanted = waves(samples_);
    const Points found = fit_.displacements(wanted);
    const Eigen::VectorXd areas = areas_ / areas_.mean();
    const double share = 0.05 * static_cast<double>(samples_.rows()) / shape_.vertex_count();
    const Eigen::MatrixXd laplacian = shape_.laplacian();
    const Points gradient = weights_.transpose() * areas.asDiagonal() * (weights_ * found - wanted)
                            + share * laplacian.transpose() * (laplacian * found);
    EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-11);
}

TEST_F(ControlMeshFitTest, TheUnitOfTheAreasDoesNotMatter)
{
    const ControlMeshFit other(weights_, 1e6 * areas_, shape_.laplacian(), 0.05);
    const Points wanted = waves(samples_);
    EXPECT_LT((other.displacements(wanted) - fit_.displacements(wanted)).cwiseAbs().maxCoeff(),
              1e-9);
}

TEST_F(ControlMeshFitTest, RefusesWhatItCannotFit)
{
    EXPECT_THROW(ControlMeshFit(weights_, areas_, shape_.laplacian(), 0.0), InvalidInput);
    EXPECT_THROW(ControlMeshFit(weights_, 0.0 * areas_, shape_.laplacian(), 0.05), InvalidInput);
    EXPECT_THROW(ControlMeshFit(weights_, areas_.head(3), shape_.laplacian(), 0.05), InvalidInput);
    EXPECT_THROW(ControlMeshFit(weights_, areas_, ControlShape(1).laplacian(), 0.05), InvalidInput);
    // Fewer samples than vertices, and nothing that smooths between them.
    EXPECT_THROW(ControlMeshFit(weights_, areas_, shape_.laplacian(), 1e-300), InvalidInput);
}

TEST(DenseCholeskyTest, SolvesAndHalfSolvesAsEigenDoes)
{
    const Weights root = Weights::Random(131, 131);
    const Weights matrix = root * root.transpose() + 20.0 * Weights::Identity(131, 131);
    const DenseCholesky factor(matrix);
    const Points right = Points::Random(131, 3);
    EXPECT_LT((matrix * factor.solve(right) - right).norm(), 1e-12);
    const Weights rows = Weights::Random(7, 131), others = Weights::Random(5, 131);
    const Weights product =
        factor.half_solve_rows(rows) * factor.half_solve_rows(others).transpose();
    const Weights expected = rows * Eigen::MatrixXd(matrix).llt().solve(others.transpose());
    EXPECT_LT((product - expected).norm(), 1e-12);
    EXPECT_THROW(DenseCholesky(-matrix), SolverError);
}

TEST(DenseProductsTest, AgreeWithEigenForEveryRemainder)
{
    for (int rows : {1, 3, 4, 9})
        for (int columns : {1, 7, 16, 33})
        {
            const Weights left = Weights::Random(rows, columns),
                          right = Weights::Random(columns, 5);
            Weights result = Weights::Ones(rows, 5);
            add_product(left, right.transpose(), -2.0, result);
            const Weights expected = Weights::Ones(rows, 5) - 2.0 * left * right;
            EXPECT_LT((result - expected).norm(), 1e-12) << rows << " x " << columns;
            const Points narrow = right.leftCols(3);
            EXPECT_LT((narrow_product(left, narrow) - left * narrow).norm(), 1e-12);
        }
}

}  // namespace

}  // namespace sheetmorph::volume

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/numerics/cholesky/frontal_cholesky.h"

#include <algorithm>

namespace sheetmorph
{

SparseCholesky::SparseCholesky(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree,
                               const SparseCholesky* earlier)
    : elimination_(std::move(matrix), std::move(tree)), solver_(fronts(earlier))
{
}

FrontList SparseCholesky::fronts(const SparseCholesky* earlier) const
{
    try
    {
        if (earlier == nullptr)
            return frontal_cholesky(elimination_);
        const EarlierFactor before{earlier->elimination_, earlier->solver_.factor()};
        return frontal_cholesky(elimination_, &before);
    }
    catch (const SolverError&)
    {
        throw SolverError(
            "the energy's matrix is not positive definite; "
            "the part has no unique shape under these constraints");
    }
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right_sides) const
{
    const auto slot_of = [this](Eigen::Index row)
    { return elimination_.slot_of(static_cast<int>(row)); };
    Eigen::MatrixXd result(right_sides.rows(), right_sides.cols());
    FrontSolver::RightSides some =
        FrontSolver::RightSides::Zero(solver_.factor().slots, right_sides_at_once);
    for (Eigen::Index first = 0; first < right_sides.cols(); first += right_sides_at_once)
    {
        const Eigen::Index count =
            std::min<Eigen::Index>(right_sides_at_once, right_sides.cols() - first);
        for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
            for (Eigen::Index column = 0; column < count; ++column)
                some(slot_of(row), column) = right_sides(row, first + column);
        solver_.solve(some);
        for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
            for (Eigen::Index column = 0; column < count; ++column)
                result(row, first + column) = some(slot_of(row), column);
    }
    return result;
}

SparseMatrix rows_scaled(const SparseMatrix& matrix, const Eigen::VectorXd& factors)
{
    SparseMatrix scaled = matrix;
    for (Eigen::Index column = 0; column < scaled.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry)
            entry.valueRef() *= factors(entry.row());
    return scaled;
}

SparseMatrix own_product(const SparseMatrix& rows, const Eigen::VectorXd& weights)
{
    const SparseMatrix scaled = rows_scaled(rows, weights.cwiseSqrt());
    return SparseMatrix(scaled.transpose()) * scaled;
}

std::string linear_algebra_version()
{
    return "Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "."
           + std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION);
}

}  // namespace sheetmorph

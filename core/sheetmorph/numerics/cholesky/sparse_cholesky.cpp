// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/numerics/cholesky/frontal_cholesky.h"
#include "sheetmorph/numerics/cholesky/half_solve.h"

#include <algorithm>

namespace sheetmorph::numerics
{

SparseCholesky::SparseCholesky(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree,
                               const SparseCholesky* earlier)
    : SparseCholesky(std::make_shared<const FrontPattern>(
                         Elimination(std::move(matrix), std::move(tree)),
                         earlier != nullptr ? earlier->pattern_.get() : nullptr),
                     earlier)
{
    find_values(*pattern_->elimination().matrix().whole);
}

SparseCholesky::SparseCholesky(std::shared_ptr<const FrontPattern> pattern)
    : SparseCholesky(std::move(pattern), nullptr)
{
}

SparseCholesky::SparseCholesky(std::shared_ptr<const FrontPattern> pattern,
                               const SparseCholesky* earlier)
    : pattern_(std::move(pattern)),
      solver_(new_fronts(*pattern_, earlier != nullptr ? &earlier->solver_.factor() : nullptr))
{
}

void SparseCholesky::factorise(const SparseMatrix& whole)
{
    const auto& fronts = solver_.factor().fronts;
    if (!pattern_->unchanged_subtrees().empty()
        || std::any_of(fronts.begin(), fronts.end(),
                       [](const auto& front) { return front.use_count() > 1; }))
        *this = SparseCholesky(std::make_shared<const FrontPattern>(pattern_->elimination()));
    find_values(whole);
}

void SparseCholesky::find_values(const SparseMatrix& whole)
{
    try
    {
        factorise_fronts(*pattern_, whole, solver_.factor());
    }
    catch (const SolverError&)
    {
        throw SolverError(
            "the constraints do not determine a unique shape (the energy's matrix is not positive "
            "definite): mark a fixed region on it, and remove its triangles without height");
    }
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right_sides) const
{
    const Eigen::Index sides =
        right_sides.cols() > few_sides && has_many_sides() ? many_sides : few_sides;
    FrontSolver::Groups groups(static_cast<std::size_t>((right_sides.cols() + sides - 1) / sides));
    if (groups.empty())
        return right_sides;
    const auto each_group = [&](const auto& visit)
    {
        parallel_items(static_cast<Eigen::Index>(groups.size()),
                       [&](Eigen::Index g)
                       {
                           const Eigen::Index first = g * sides;
                           const auto count = std::min(sides, right_sides.cols() - first);
                           visit(groups[static_cast<std::size_t>(g)], first, count);
                       });
    };
    each_group(
        [&](FrontSolver::RightSides& group, Eigen::Index first, Eigen::Index count)
        {
            group.setZero(solver_.factor().slots, sides);
            for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
                for (Eigen::Index column = 0; column < count; ++column)
                    group(slot_of(row), column) = right_sides(row, first + column);
        });
    solver_.solve(groups);
    Eigen::MatrixXd result(right_sides.rows(), right_sides.cols());
    each_group(
        [&](const FrontSolver::RightSides& group, Eigen::Index first, Eigen::Index count)
        {
            for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
                for (Eigen::Index column = 0; column < count; ++column)
                    result(row, first + column) = group(slot_of(row), column);
        });
    return result;
}

Weights SparseCholesky::solved_product(const SparseMatrix& right) const
{
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index column = 0; column < right.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(right, column); entry; ++entry)
            entries.emplace_back(slot_of(entry.row()), static_cast<int>(column), entry.value());
    Eigen::SparseMatrix<double, Eigen::RowMajor> by_slot(solver_.factor().slots, right.cols());
    by_slot.setFromTriplets(entries.begin(), entries.end());
    Weights product = half_solved_product(solver_.factor(), by_slot);
    product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
    return product;
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

}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "numerics/cholesky/cholmod_oracle.h"

#include <numeric>

namespace sheetmorph::numerics
{

CholmodOracle::CholmodOracle(SparseMatrix matrix) : matrix_(std::move(matrix))
{
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix_.rows());
    view.nzmax = static_cast<std::size_t>(matrix_.nonZeros());
    view.p = matrix_.outerIndexPtr();
    view.i = matrix_.innerIndexPtr();
    view.x = matrix_.valuePtr();
    view.stype = -1;
    view.xtype = CHOLMOD_REAL;
    view.sorted = view.packed = 1;
    factor_ = cholmod_analyze(&view, &common_);
    cholmod_factorize(&view, factor_, &common_);
}

CholmodOracle::~CholmodOracle()
{
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
}

Eigen::MatrixXd CholmodOracle::solve(const Eigen::MatrixXd& right_sides)
{
    cholmod_dense view{};
    view.nrow = view.d = static_cast<std::size_t>(right_sides.rows());
    view.ncol = static_cast<std::size_t>(right_sides.cols());
    view.nzmax = view.nrow * view.ncol;
    view.x = const_cast<double*>(right_sides.data());
    view.xtype = CHOLMOD_REAL;
    cholmod_dense* found = cholmod_solve(CHOLMOD_A, factor_, &view, &common_);
    const Eigen::MatrixXd solution = Eigen::Map<const Eigen::MatrixXd>(
        static_cast<const double*>(found->x), right_sides.rows(), right_sides.cols());
    cholmod_free_dense(&found, &common_);
    return solution;
}

SparseMatrix written_out(const MergedMatrix& matrix)
{
    std::vector<Eigen::Triplet<double>> ones;
    for (std::size_t row = 0; row < matrix.unknown_of.size(); ++row)
        if (matrix.unknown_of[row] >= 0)
            ones.emplace_back(static_cast<int>(row), matrix.unknown_of[row], 1.0);
    SparseMatrix basis(matrix.whole->rows(), matrix.count);
    basis.setFromTriplets(ones.begin(), ones.end());
    return SparseMatrix(basis.transpose()) * *matrix.whole * basis;
}

MergedMatrix all_of(const SparseMatrix& matrix)
{
    return unmerged(std::make_shared<const SparseMatrix>(matrix));
}

std::shared_ptr<const SeparatorTree> one_node(int rows)
{
    SeparatorTree tree{std::vector<int>(static_cast<std::size_t>(rows)), {0, rows}, {-1}, {0}};
    std::iota(tree.order.begin(), tree.order.end(), 0);
    return std::make_shared<const SeparatorTree>(std::move(tree));
}

}  // namespace sheetmorph::numerics

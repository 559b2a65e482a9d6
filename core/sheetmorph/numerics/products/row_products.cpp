// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/row_products.h"

#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>

namespace sheetmorph::numerics
{

namespace
{

// Fewest columns worth a thread. Chosen, not measured: estimated at 10 ns each, 100 microseconds.
constexpr Eigen::Index least_columns = 10000;

// Packs columns of a matrix, from `first` on, as far as they exist and fit.
template <typename Packed>
void pack(const Eigen::MatrixXd& matrix, Eigen::Index first, Packed& packed)
{
    const Eigen::Index count =
        std::min<Eigen::Index>(Packed::ColsAtCompileTime, matrix.cols() - first);
    packed.resize(matrix.rows(), Packed::ColsAtCompileTime);
    if (count < Packed::ColsAtCompileTime)
        packed.setZero();
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        for (Eigen::Index k = 0; k < count; ++k)
            packed(row, k) = matrix(row, first + k);
}

template <typename Packed>
void unpack(const Packed& packed, Eigen::Index first, Eigen::MatrixXd& matrix)
{
    const Eigen::Index count =
        std::min<Eigen::Index>(Packed::ColsAtCompileTime, matrix.cols() - first);
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        for (Eigen::Index k = 0; k < count; ++k)
            matrix(row, first + k) = packed(row, k);
}

}  // namespace

RowProducts::RowProducts(const SparseMatrix& rows, const Eigen::VectorXd& weights)
    : rows_(rows), weights_(weights)
{
}

// f - B u for four columns.
void RowProducts::take_off(const Eigen::MatrixXd& f, const Eigen::MatrixXd& u, Eigen::Index first)
{
    pack(f, first, of_rows_);
    pack(u, first, of_columns_);
    for (Eigen::Index column = 0; column < rows_.outerSize(); ++column)
    {
        const Eigen::RowVector4d value = of_columns_.row(column);
        for (SparseMatrix::InnerIterator entry(rows_, column); entry; ++entry)
            of_rows_.row(entry.row()) -= entry.value() * value;
    }
}

// B^T diag(w) for four columns.
void RowProducts::pull_packed()
{
    of_columns_.resize(rows_.cols(), together);
    const auto pull_columns = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index column = begin; column < end; ++column)
        {
            Eigen::RowVector4d sum = Eigen::RowVector4d::Zero();
            for (SparseMatrix::InnerIterator entry(rows_, column); entry; ++entry)
                sum += entry.value() * weights_(entry.row()) * of_rows_.row(entry.row());
            of_columns_.row(column) = sum;
        }
    };
    parallel_ranges(rows_.cols(), least_columns, pull_columns);
}

Eigen::MatrixXd RowProducts::left(const Eigen::MatrixXd& f, const Eigen::MatrixXd& u)
{
    Eigen::MatrixXd result(f.rows(), f.cols());
    for (Eigen::Index first = 0; first < f.cols(); first += together)
    {
        take_off(f, u, first);
        unpack(of_rows_, first, result);
    }
    return result;
}

Eigen::MatrixXd RowProducts::pull(const Eigen::MatrixXd& left)
{
    Eigen::MatrixXd result(rows_.cols(), left.cols());
    for (Eigen::Index first = 0; first < left.cols(); first += together)
    {
        pack(left, first, of_rows_);
        pull_packed();
        unpack(of_columns_, first, result);
    }
    return result;
}

Eigen::MatrixXd RowProducts::reduced_pull(const Eigen::MatrixXd& f, const Eigen::MatrixXd& u,
                                          const SparseMatrix& basis)
{
    Eigen::MatrixXd result(basis.cols(), f.cols());
    for (Eigen::Index first = 0; first < f.cols(); first += together)
    {
        take_off(f, u, first);
        pull_packed();
        const Eigen::Index count = std::min<Eigen::Index>(together, f.cols() - first);
        for (Eigen::Index unknown = 0; unknown < basis.outerSize(); ++unknown)
        {
            Eigen::RowVector4d sum = Eigen::RowVector4d::Zero();
            for (SparseMatrix::InnerIterator entry(basis, unknown); entry; ++entry)
                sum += entry.value() * of_columns_.row(entry.row());
            for (Eigen::Index k = 0; k < count; ++k)
                result(unknown, first + k) = sum(k);
        }
    }
    return result;
}

Eigen::MatrixXd expanded(const SparseMatrix& basis, const Eigen::MatrixXd& y,
                         const Eigen::MatrixXd& offset)
{
    Eigen::MatrixXd u = offset;
    for (Eigen::Index k = 0; k < y.cols(); ++k)
        for (Eigen::Index unknown = 0; unknown < basis.outerSize(); ++unknown)
            for (SparseMatrix::InnerIterator entry(basis, unknown); entry; ++entry)
                u(entry.row(), k) += y(unknown, k);
    return u;
}

}  // namespace sheetmorph::numerics

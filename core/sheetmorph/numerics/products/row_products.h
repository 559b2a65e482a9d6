// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/ordering/elimination.h"

namespace sheetmorph::numerics
{

//! Products of a sparse matrix with few columns, four of them side by side in memory. One pass over
//! the matrix then serves all four. Keeps its memory from call to call, so every thread needs its
//! own.
class RowProducts
{
public:
    //! \param rows  B (r, n); kept by reference
    RowProducts(const SparseMatrix& rows, const Eigen::VectorXd& weights);

    //! f - B u. \param f (r, k) \param u (n, k)
    Eigen::MatrixXd left(const Eigen::MatrixXd& f, const Eigen::MatrixXd& u);

    //! B^T diag(w) left (n, k).
    Eigen::MatrixXd pull(const Eigen::MatrixXd& left);

    //! S^T B^T diag(w) (f - B u) (y, k). \param basis  S (n, y)
    Eigen::MatrixXd reduced_pull(const Eigen::MatrixXd& f, const Eigen::MatrixXd& u,
                                 const SparseMatrix& basis);

private:
    static constexpr int together = 4;  // from AVX2: doubles of a register
    using Packed = Eigen::Matrix<double, Eigen::Dynamic, together, Eigen::RowMajor>;

    void take_off(const Eigen::MatrixXd& f, const Eigen::MatrixXd& u, Eigen::Index first);
    void pull_packed();

    const SparseMatrix& rows_;
    const Eigen::VectorXd& weights_;
    Packed of_rows_, of_columns_;
};

//! offset + S y, (n, k), for S with at most one entry 1 per row.
Eigen::MatrixXd expanded(const SparseMatrix& basis, const Eigen::MatrixXd& y,
                         const Eigen::MatrixXd& offset);

}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/ordering/elimination.h"

#include <cholmod.h>

namespace sheetmorph::numerics
{

//! The same factor by CHOLMOD, which only the tests and the benchmarks link.
class CholmodOracle
{
public:
    //! \param matrix  (n, n), symmetric positive definite
    explicit CholmodOracle(SparseMatrix matrix);
    ~CholmodOracle();
    CholmodOracle(const CholmodOracle&) = delete;
    CholmodOracle& operator=(const CholmodOracle&) = delete;

    Eigen::MatrixXd solve(const Eigen::MatrixXd& right_sides);

    //! Entries of a factor in dense blocks after a minimum-degree ordering.
    double factor_entries() const { return static_cast<double>(factor_->xsize); }

private:
    SparseMatrix matrix_;
    cholmod_common common_{};
    cholmod_factor* factor_ = nullptr;
};

//! S^T M S written out.
SparseMatrix written_out(const MergedMatrix& matrix);

//! All rows of a matrix as unknowns.
MergedMatrix all_of(const SparseMatrix& matrix);

//! The tree of one node, which any matrix may have.
std::shared_ptr<const SeparatorTree> one_node(int rows);

}  // namespace sheetmorph::numerics

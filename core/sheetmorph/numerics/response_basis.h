// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"
#include "sheetmorph/numerics/response_kernel.h"

namespace sheetmorph
{

//! Displacements that are linear in a few numbers: u = Phi c with Phi (n, k) tall and c (k, 3).
//! Kept in float32, 4 k bytes a row; a product reads it once and is as fast as the memory.
class ResponseBasis
{
public:
    using Coefficients = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

    //! All zero.
    ResponseBasis(Eigen::Index rows, Eigen::Index columns);

    //! Columns first .. first + block.cols() - 1 from (n, j); relative rounding 6e-8.
    void set_columns(Eigen::Index first, const Eigen::MatrixXd& block);

    //! One row of Phi c.
    Vector3 row(Eigen::Index row, const Coefficients& coefficients) const;

    //! result = start + Phi c, both (n, 3); large ones on two threads.
    void add_to(const Points& start, const Coefficients& coefficients, Points& result) const;

    Eigen::Index rows() const { return rows_; }
    Eigen::Index columns() const { return columns_; }

private:
    Eigen::Index rows_;
    Eigen::Index columns_;
    std::vector<ResponseRows> blocks_;
};

}  // namespace sheetmorph

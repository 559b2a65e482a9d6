// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include <vector>

namespace sheetmorph::surface
{

//! The unknown of each vertex: one per free vertex, one per rigid body.
struct Unknowns
{
    static constexpr int known = -1;

    std::vector<int> of_vertex;  //!< (n) 0..count-1, or known (prescribed)
    int count = 0;

    //! S (n, count) of u = S y + offset.
    numerics::SparseMatrix basis() const;

    //! S^T rows: sums of the rows with the same unknown.
    //! \param rows  (n, k)
    //! \returns     (count, k)
    Eigen::MatrixXd sums(const Eigen::MatrixXd& rows) const;

    //! S^T M S.
    //! \param whole  M (n, n), both triangles
    numerics::MergedMatrix merged(std::shared_ptr<const numerics::SparseMatrix> whole) const
    {
        return {std::move(whole), of_vertex, count};
    }
};

}  // namespace sheetmorph::surface

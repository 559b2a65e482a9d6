// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/numerics/products/dense_products.h"

#include <cstdint>
#include <vector>

namespace sheetmorph::numerics
{

//! A dense matrix (r, k) that is often multiplied by three columns. Eight rows are stored side by
//! side, so that no sum runs across a register. A live product reads a float of each entry, an
//! exact product its remainder too.
//! \tparam Remainder  float: entries are exact to 2^-48 of their size; std::int16_t: to 2^-39 of
//! the largest entry of their row, in three quarters of the memory
template <typename Remainder>
class PanelRows
{
public:
    //! A matrix of zeros.
    explicit PanelRows(Eigen::Index rows = 0, Eigen::Index columns = 0);

    explicit PanelRows(const Weights& rows);

    //! Replaces the rows from `first`, a multiple of 8, on.
    void set(Eigen::Index first, const Weights& rows);

    Eigen::Index rows() const { return rows_; }

    //! (r, 3). \param right  (k, 3)
    Points times(const Points& right, Exactness exactness = Exactness::exact) const;

private:
    struct alignas(32) Entries
    {
        float at[8];  // a column of eight rows
    };
    struct alignas(8 * sizeof(Remainder)) Remainders
    {
        Remainder at[8];
    };
    Eigen::Index rows_, columns_;
    std::vector<Entries> first_;  // of every eight rows, column by column
    std::vector<Remainders> rest_;
};

using ExactPanelRows = PanelRows<float>;
using CompactPanelRows = PanelRows<std::int16_t>;

}  // namespace sheetmorph::numerics

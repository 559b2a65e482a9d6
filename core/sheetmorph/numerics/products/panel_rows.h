// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/numerics/products/dense_products.h"

#include <vector>

namespace sheetmorph::numerics
{

//! A dense matrix (r, k) that is multiplied by three columns again and again: eight rows stand side
//! by side, so that no sum runs across a register. Entries are kept as two floats, to 4e-15 of
//! each; a live product reads the first alone: half of the memory, which is what it takes.
class PanelRows
{
public:
    //! Zeros.
    explicit PanelRows(Eigen::Index rows = 0, Eigen::Index columns = 0);

    explicit PanelRows(const Weights& rows);

    //! Replaces the rows from `first` on, a multiple of 8.
    void set(Eigen::Index first, const Weights& rows);

    //! (r, 3). \param right  (k, 3)
    Points times(const Points& right, Exactness exactness = Exactness::exact) const;

private:
    struct alignas(32) Entries
    {
        float at[8];  // a column of eight rows
    };
    Eigen::Index rows_, columns_;
    std::vector<Entries> first_, rest_;  // of every eight rows, column by column
};

}  // namespace sheetmorph::numerics

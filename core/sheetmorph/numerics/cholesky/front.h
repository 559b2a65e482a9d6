// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/front_pattern.h"
#include "sheetmorph/numerics/products/dense_products.h"

#include <memory>
#include <vector>

namespace sheetmorph::numerics
{

//! Columns of a sparse Cholesky factor that share their rows. The first rows are those of the
//! front's own unknowns.
struct Front
{
    int columns = 0;
    FrontRows shared_rows;
    std::unique_ptr<double[]> entries;  //!< (rows, columns), rows contiguous; above the diagonal
                                        //!< undefined

    //! Slots, in the order of elimination.
    const std::vector<int>& rows() const { return *shared_rows; }

    int height() const { return static_cast<int>(rows().size()); }
    int below() const { return height() - columns; }
    double count() const { return static_cast<double>(height()) * columns; }

    Eigen::Map<Weights> panel() const { return {entries.get(), height(), columns}; }
};

//! A factor L L^T in fronts. Every front comes before those that it updates.
struct FrontList
{
    int slots = 0;                               //!< rows of right-hand sides
    std::vector<std::shared_ptr<Front>> fronts;  //!< (f)
    std::vector<int> parent;                     //!< (f) front above; -1 for none

    //! Number of entries of the factor.
    double count() const
    {
        double sum = 0.0;
        for (const auto& front : fronts)
            sum += front->count();
        return sum;
    }
};

}  // namespace sheetmorph::numerics

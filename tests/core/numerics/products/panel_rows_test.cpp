// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/panel_rows.h"

#include <gtest/gtest.h>

namespace sheetmorph::numerics
{
namespace
{

TEST(PanelRows, MultipliesAsTheMatrix)
{
    for (const Eigen::Index rows : {0, 1, 7, 8, 31, 32, 100})
        for (const Eigen::Index columns : {0, 1, 5, 64})
        {
            const Weights matrix = Weights::Random(rows, columns);
            const Points right = Points::Random(columns, 3);
            const Points product = PanelRows(matrix).times(right);
            ASSERT_EQ(product.rows(), rows);
            EXPECT_LT((product - matrix * right).norm(), 1e-13) << rows << " x " << columns;
            const Points live = PanelRows(matrix).times(right, Exactness::live);
            EXPECT_LE((live - product).norm(), 1e-7 * matrix.norm() * right.norm());
        }
}

TEST(PanelRows, RowsCanBeSetSomeAtATime)
{
    const Weights matrix = Weights::Random(27, 6);
    const Points right = Points::Random(6, 3);
    PanelRows rows(27, 6);
    EXPECT_EQ(rows.times(right), Points(Points::Zero(27, 3)));
    rows.set(16, matrix.bottomRows(11));
    rows.set(0, matrix.topRows(16));
    EXPECT_EQ(rows.times(right), PanelRows(matrix).times(right));
}

}  // namespace
}  // namespace sheetmorph::numerics

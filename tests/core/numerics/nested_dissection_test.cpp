// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/nested_dissection.h"

#include "sheetmorph/numerics/sparse_cholesky.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sheetmorph
{
namespace
{

struct Grid
{
    SparseMatrix matrix;
    Points places;
};

// The square of a grid's graph Laplacian, shifted: the pattern of a bilaplacian.
Grid grid(int columns, int rows)
{
    const int count = columns * rows;
    std::vector<Eigen::Triplet<double>> entries;
    Grid made{SparseMatrix(count, count), Points(count, 3)};
    for (int i = 0; i < count; ++i)
    {
        made.places.row(i) << i % columns, i / columns, 0.0;
        entries.emplace_back(i, i, 4.1);
        for (const int other : {i % columns + 1 < columns ? i + 1 : i, i + columns})
            if (other != i && other < count)
            {
                entries.emplace_back(i, other, -1.0);
                entries.emplace_back(other, i, -1.0);
            }
    }
    made.matrix.setFromTriplets(entries.begin(), entries.end());
    made.matrix = SparseMatrix(made.matrix * made.matrix);
    return made;
}

TEST(NestedDissection, OrdersEveryUnknownOnce)
{
    const Grid sheet = grid(40, 25);
    std::vector<int> order = nested_dissection(sheet.matrix, sheet.places);
    std::sort(order.begin(), order.end());
    for (int k = 0; k < 1000; ++k)
        ASSERT_EQ(order[static_cast<std::size_t>(k)], k);
}

TEST(NestedDissection, TakesUnknownsThatAllLieInOnePlace)
{
    Grid sheet = grid(20, 20);
    sheet.places.setZero();
    EXPECT_EQ(nested_dissection(sheet.matrix, sheet.places).size(), 400U);
    EXPECT_TRUE(nested_dissection(SparseMatrix(0, 0), Points(0, 3)).empty());
}

TEST(NestedDissection, FillsALargeSheetHardlyMoreThanMinimumDegreeDoes)
{
    const Grid sheet = grid(300, 240);
    const SparseCholesky by_places(sheet.matrix, sheet.places);
    const SparseCholesky by_degree(sheet.matrix);
    EXPECT_NE(by_places.factor_entries(), by_degree.factor_entries());
    EXPECT_LT(by_places.factor_entries(), 1.1 * by_degree.factor_entries());
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(72000, 5);
    const Eigen::MatrixXd found = by_places.solve(right);
    EXPECT_LT((sheet.matrix * found - right).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((found - by_degree.solve(right)).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace sheetmorph

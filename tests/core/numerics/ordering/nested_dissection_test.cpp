// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/ordering/nested_dissection.h"

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "numerics/cholesky/cholmod_oracle.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace sheetmorph::numerics
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
    std::vector<int> order = nested_dissection(sheet.matrix, sheet.places).order;
    std::sort(order.begin(), order.end());
    for (int k = 0; k < 1000; ++k)
        ASSERT_EQ(order[static_cast<std::size_t>(k)], k);
}

TEST(NestedDissection, TakesUnknownsThatAllLieInOnePlace)
{
    Grid sheet = grid(20, 20);
    sheet.places.setZero();
    EXPECT_EQ(nested_dissection(sheet.matrix, sheet.places).order.size(), 400U);
    EXPECT_EQ(nested_dissection(SparseMatrix(0, 0), Points(0, 3)).size(), 0);
}

TEST(NestedDissection, CouplesNodesOnlyWithThoseAboveThem)
{
    const Grid sheet = grid(200, 140);
    const SeparatorTree tree = nested_dissection(sheet.matrix, sheet.places);
    std::vector<int> node_of(28000);
    for (int node = 0; node < tree.size(); ++node)
    {
        EXPECT_TRUE(tree.parent[static_cast<std::size_t>(node)] > node || node == tree.size() - 1);
        for (int k = tree.first[static_cast<std::size_t>(node)];
             k < tree.first[static_cast<std::size_t>(node) + 1]; ++k)
            node_of[static_cast<std::size_t>(tree.order[static_cast<std::size_t>(k)])] = node;
    }
    for (int column = 0; column < 28000; ++column)
        for (SparseMatrix::InnerIterator entry(sheet.matrix, column); entry; ++entry)
        {
            const int a = node_of[static_cast<std::size_t>(column)];
            const int b = node_of[static_cast<std::size_t>(entry.row())];
            ASSERT_TRUE(tree.is_below(a, b) || tree.is_below(b, a));
        }
}

// Bent at right angles along lines across it, every so many columns, turned by whole quarters,
// numbered at random, rounded like places that were computed.
Grid bent_grid(int columns, int rows, std::mt19937& random)
{
    const auto draw = [&random](int least, int most)
    { return std::uniform_int_distribution<int>(least, most)(random); };
    Eigen::MatrixX2d profile(columns, 2);
    Eigen::RowVector2d place(0.0, 0.0), step(1.0, 0.0);
    for (int column = 0, next = draw(10, columns); column < columns; ++column)
    {
        profile.row(column) = place;
        place += step;
        if (column != next)
            continue;
        next += draw(10, columns);
        step = draw(0, 1) == 0 ? Eigen::RowVector2d(-step(1), step(0))
                               : Eigen::RowVector2d(step(1), -step(0));
    }
    const Grid flat = grid(columns, rows);
    const int axis = draw(0, 2);
    std::vector<int> number(static_cast<std::size_t>(columns * rows));
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    Grid bent{SparseMatrix(), Points(columns * rows, 3)};
    Eigen::PermutationMatrix<Eigen::Dynamic> order(columns * rows);
    for (int i = 0; i < columns * rows; ++i)
    {
        const int to = number[static_cast<std::size_t>(i)];
        order.indices()(i) = to;
        bent.places(to, axis) = profile(i % columns, 0);
        bent.places(to, (axis + 1) % 3) = profile(i % columns, 1);
        bent.places(to, (axis + 2) % 3) = flat.places(i, 1);
    }
    bent.places += 1e-12 * Points::Random(columns * rows, 3);
    bent.matrix = order * flat.matrix * order.transpose();
    return bent;
}

TEST(NestedDissection, FillsBentSheetsHardlyMoreThanMinimumDegreeDoes)
{
    std::mt19937 random(20);
    for (int trial = 0; trial < 12; ++trial)
    {
        const Grid sheet = bent_grid(160, 100, random);
        const SparseCholesky by_places(
            all_of(sheet.matrix),
            std::make_shared<const SeparatorTree>(nested_dissection(sheet.matrix, sheet.places)));
        EXPECT_LT(by_places.factor_entries(), 1.3 * CholmodOracle(sheet.matrix).factor_entries())
            << "sheet " << trial;
    }
}

TEST(NestedDissection, FillsALargeSheetHardlyMoreThanMinimumDegreeDoes)
{
    const Grid sheet = grid(300, 240);
    const SparseCholesky by_places(
        all_of(sheet.matrix),
        std::make_shared<const SeparatorTree>(nested_dissection(sheet.matrix, sheet.places)));
    CholmodOracle by_degree(sheet.matrix);
    EXPECT_LT(by_places.factor_entries(), 1.1 * by_degree.factor_entries());
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(72000, 5);
    const Eigen::MatrixXd found = by_places.solve(right);
    EXPECT_LT((sheet.matrix * found - right).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((found - by_degree.solve(right)).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace sheetmorph::numerics

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/panel_rows.h"

#include <cmath>
#include <gtest/gtest.h>
#include <type_traits>

namespace sheetmorph::numerics
{
namespace
{

template <typename Rows>
class PanelRowsOf : public testing::Test
{
};

using Kinds = testing::Types<ExactPanelRows, CompactPanelRows>;
TYPED_TEST_SUITE(PanelRowsOf, Kinds);

// Of an entry, as a share of its size.
template <typename Rows>
constexpr double precision = std::is_same_v<Rows, ExactPanelRows> ? 0x1p-48 : 0x1p-39;

TYPED_TEST(PanelRowsOf, MultipliesAsTheMatrix)
{
    for (const Eigen::Index rows : {0, 1, 7, 8, 31, 32, 100})
        for (const Eigen::Index columns : {0, 1, 5, 64})
        {
            const Weights matrix = Weights::Random(rows, columns);
            const Points right = Points::Random(columns, 3);
            const Points product = TypeParam(matrix).times(right);
            ASSERT_EQ(product.rows(), rows);
            // A remainder also takes on what the entry before it has left.
            EXPECT_LE((product - matrix * right).norm(),
                      1e-14 + 2.0 * precision<TypeParam> * matrix.norm() * right.norm())
                << rows << " x " << columns;
            const Points live = TypeParam(matrix).times(right, Exactness::live);
            EXPECT_LE((live - product).norm(), 1e-7 * matrix.norm() * right.norm());
        }
}

TYPED_TEST(PanelRowsOf, RowsCanBeSetSomeAtATime)
{
    const Weights matrix = Weights::Random(27, 6);
    const Points right = Points::Random(6, 3);
    TypeParam rows(27, 6);
    EXPECT_EQ(rows.times(right), Points(Points::Zero(27, 3)));
    rows.set(16, matrix.bottomRows(11));
    rows.set(0, matrix.topRows(16));
    EXPECT_EQ(rows.times(right), TypeParam(matrix).times(right));
}

// Columns that are equal sum up a row.
TEST(CompactPanelRowsTest, ARowSumsUpExacterThanItsEntries)
{
    const Weights matrix = Weights::Random(64, 500);
    const Points ones = Points::Ones(500, 3);
    const Points sums = CompactPanelRows(matrix).times(ones);
    EXPECT_LT((sums - matrix * ones).cwiseAbs().maxCoeff(), 2.0 * 0x1p-39);
}

// An entry takes on what rounding leaves of those before it: a share of the largest, not of its
// own.
TEST(CompactPanelRowsTest, EntriesOfAllSizesInARowAreKeptToAShareOfTheLargest)
{
    const int count = 60;
    Weights matrix = Weights::Random(16, count);
    for (int k = 0; k < count; ++k)
        matrix.col(k) *= std::pow(10.0, -(7 * k % 13));
    const CompactPanelRows rows(matrix);
    for (int k = 0; k < count; ++k)
    {
        Points one = Points::Zero(count, 3);
        one.row(k).setOnes();
        EXPECT_LT((rows.times(one) - matrix * one).cwiseAbs().maxCoeff(), 0x1p-39) << k;
    }
}

// Zeros, powers of two and their neighbours, entries far from 1, and of either sign.
TEST(CompactPanelRowsTest, AnyEntryIsKeptToItsPrecision)
{
    for (const double size : {0.0, 1e-30, 1e-12, 0.5, 1.0, 3.0, 1e9})
        for (const double factor : {1.0, 1.0 + 1e-9, 1.0 - 1e-9, 1.0 + 0x1p-24, 2.0 - 0x1p-25})
            for (const double sign : {1.0, -1.0})
            {
                const double entry = sign * size * factor;
                const Weights matrix = Weights::Constant(1, 1, entry);
                const Points product = CompactPanelRows(matrix).times(Points::Ones(1, 3));
                EXPECT_LE(std::abs(product(0, 0) - entry), 0x1p-39 * std::abs(entry)) << entry;
            }
}

}  // namespace
}  // namespace sheetmorph::numerics

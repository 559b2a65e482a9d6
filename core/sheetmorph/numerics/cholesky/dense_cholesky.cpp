// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/dense_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sheetmorph::numerics
{

namespace
{

// Rows of a block. The triangular work inside blocks is slow. The products between blocks are fast,
// but every block reads all columns before it. Chosen: a multiple of the tiles of a product (6 rows
// and 4, 8 or 16 columns); a block of 48 rows, 18 KiB, fits the first cache of 32 KiB.
constexpr Eigen::Index largest_block = 48;

Eigen::Index block_rows(Eigen::Index columns)
{
    return std::min<Eigen::Index>(columns, columns <= 96 ? 16 : largest_block);
}

// Finishes the columns from `first` on: subtracts the columns before them and multiplies by
// (L_jj)^-T.
void finish_columns(const Weights& inverse_blocks, Eigen::Index first, WeightsTarget rows)
{
    const Eigen::Index wide = std::min(inverse_blocks.cols(), inverse_blocks.rows() - first);
    const Weights right = rows.middleCols(first, wide);
    rows.middleCols(first, wide).setZero();
    add_product(right, inverse_blocks.block(first, 0, wide, wide), 1.0,
                rows.middleCols(first, wide));
}

// Multiplications of a range. Chosen, not measured: estimated at 1e10 a second, they take 100
// microseconds, three times as long as waking a thread (thread_pool.cpp).
constexpr double least_work = 1e6;

// Chosen: every range reads the other factor of its product again, so more ranges read too much.
constexpr Eigen::Index most_ranges = 16;

// Fewest of `items` in a range, for all items together this much work.
Eigen::Index least_items(Eigen::Index items, double work)
{
    const double ranges = std::clamp(work / least_work, 1.0, static_cast<double>(most_ranges));
    return static_cast<Eigen::Index>(std::ceil(static_cast<double>(items) / ranges));
}

// Cholesky factor of one diagonal block, and its inverse, whose upper triangle must be zero
// already. The inner loops run along rows, which are contiguous.
void factorise_block(WeightsTarget diagonal, WeightsTarget inverse)
{
    const Eigen::Index size = diagonal.rows();
    std::array<double, largest_block> column;
    for (Eigen::Index k = 0; k < size; ++k)
    {
        const double pivot = diagonal(k, k);
        if (!(pivot > 0.0))
            throw SolverError(
                "the constraints do not determine a unique shape (a dense matrix is not positive "
                "definite)");
        const double root = std::sqrt(pivot);
        diagonal(k, k) = root;
        for (Eigen::Index i = k + 1; i < size; ++i)
        {
            column[at(i)] = diagonal(i, k) /= root;
            for (Eigen::Index j = k + 1; j <= i; ++j)
                diagonal(i, j) -= column[at(i)] * column[at(j)];
        }
    }
    for (Eigen::Index i = 0; i < size; ++i)
    {
        for (Eigen::Index k = 0; k < i; ++k)
            for (Eigen::Index j = 0; j <= k; ++j)
                inverse(i, j) -= diagonal(i, k) * inverse(k, j);
        inverse.row(i).head(i) /= diagonal(i, i);
        inverse(i, i) = 1.0 / diagonal(i, i);
    }
}

}  // namespace

void factorise_columns(WeightsTarget panel, Weights& inverse_blocks)
{
    const Eigen::Index columns = panel.cols(), block = block_rows(columns);
    inverse_blocks.setZero(columns, block);
    for (Eigen::Index j = 0; j < columns; j += block)
    {
        const Eigen::Index wide = std::min(block, columns - j), below = panel.rows() - j - wide;
        const double work = static_cast<double>(below) * static_cast<double>((j + wide) * wide);
        const auto before = [&](Eigen::Index first, Eigen::Index count)
        {
            add_product(panel.block(first, 0, count, j), panel.block(j, 0, wide, j), -1.0,
                        panel.block(first, j, count, wide));
        };
        before(j, wide);
        factorise_block(panel.block(j, j, wide, wide), inverse_blocks.block(j, 0, wide, wide));
        parallel_ranges(below, least_items(below, work),
                        [&](Eigen::Index begin, Eigen::Index end)
                        {
                            const Eigen::Index first = j + wide + begin;
                            before(first, end - begin);
                            finish_columns(inverse_blocks, j, panel.middleRows(first, end - begin));
                        });
    }
}

void subtract_own_product(const WeightsView& rows, WeightsTarget result)
{
    // Shares of rows with equal parts of the triangle. Chosen: at most 16 ranges round them well.
    constexpr Eigen::Index shares = 1024;
    const auto count = static_cast<double>(rows.rows());
    const auto row_at = [count](Eigen::Index share)
    { return static_cast<Eigen::Index>(count * std::sqrt(1.0 * share / shares)); };
    const double work = 0.5 * count * count * static_cast<double>(rows.cols());
    parallel_ranges(shares, least_items(shares, work),
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        const Eigen::Index first = row_at(begin), high = row_at(end) - first;
                        const auto own = rows.middleRows(first, high);
                        add_product(own, rows.topRows(first), -1.0,
                                    result.block(first, 0, high, first));
                        add_lower_product(own, own, -1.0, result.block(first, first, high, high));
                    });
}

DenseCholesky::DenseCholesky(Weights matrix) : lower_(std::move(matrix))
{
    factorise_columns(lower_, inverse_blocks_);
}

Points DenseCholesky::solve(const Points& right) const
{
    return solve_upper(lower_.triangularView<Eigen::Lower>().solve(right));
}

Eigen::VectorXd DenseCholesky::solve(const Eigen::VectorXd& right) const
{
    const auto lower = lower_.triangularView<Eigen::Lower>();
    return lower.transpose().solve(lower.solve(right));
}

Points DenseCholesky::solve_upper(const Points& right) const
{
    return lower_.triangularView<Eigen::Lower>().transpose().solve(right);
}

Weights DenseCholesky::half_solve_rows(Weights rows) const
{
    const Eigen::Index block = inverse_blocks_.cols();
    for (Eigen::Index j = 0; j < lower_.rows(); j += block)
    {
        const Eigen::Index wide = std::min(block, lower_.rows() - j);
        add_product(rows.leftCols(j), lower_.block(j, 0, wide, j), -1.0, rows.middleCols(j, wide));
        finish_columns(inverse_blocks_, j, rows);
    }
    return rows;
}

}  // namespace sheetmorph::numerics

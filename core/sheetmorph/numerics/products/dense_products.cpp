// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/dense_products.h"

#include "sheetmorph/base/instructions/widest.h"

#include <algorithm>
#include <cstring>
#include <vector>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph::numerics
{

namespace
{

// Twelve sums of two registers are under way at once, as many as 16 registers have room for.
constexpr int tile_rows = 6;
constexpr int largest_panel = 16;

// Doubles a register for three columns: the sums of wider ones take longer than they save.
constexpr int narrow = 4;

// Rows of doubles `stride` apart.
struct Rows
{
    const double* data;
    Eigen::Index stride;
};

// A tile of the product: tile_rows rows of `left` against a packed panel of 2 * width columns.
struct Tile
{
    const double* left[tile_rows];
    const double* panel;  // (depth, 2 * width)
    Eigen::Index depth;
    double factor;
    double* result[tile_rows];  // whole tiles are added here, others left in `sums`
    bool is_whole;
    double sums[tile_rows][largest_panel];
};

template <int width>
struct Kernel
{
    using Lanes = typename VectorTypes<width>::Lanes;

    static SHEETMORPH_INLINE Lanes load(const double* from)
    {
        Lanes value;
        std::memcpy(&value, from, sizeof value);
        return value;
    }

    static SHEETMORPH_INLINE void multiply(Tile& tile)
    {
        Lanes sums[tile_rows][2] = {};
        for (Eigen::Index k = 0; k < tile.depth; ++k)
        {
            const Lanes first = load(tile.panel + 2 * width * k);
            const Lanes second = load(tile.panel + 2 * width * k + width);
            for (int r = 0; r < tile_rows; ++r)
            {
                sums[r][0] += tile.left[r][k] * first;
                sums[r][1] += tile.left[r][k] * second;
            }
        }
        for (int r = 0; r < tile_rows; ++r)
            for (int half = 0; half < 2; ++half)
            {
                double* const to = (tile.is_whole ? tile.result[r] : tile.sums[r]) + half * width;
                const Lanes product = tile.factor * sums[r][half];
                const Lanes sum = tile.is_whole ? load(to) + product : product;
                std::memcpy(to, &sum, sizeof sum);
            }
    }

    static SHEETMORPH_INLINE double total(const Lanes& value)
    {
        double sum = 0.0;
        for (int l = 0; l < width; ++l)
            sum += value[l];
        return sum;
    }

    // `row` times three columns, each contiguous.
    static SHEETMORPH_INLINE void multiply(const double* row, const Rows& columns,
                                           Eigen::Index depth, double* result)
    {
        Lanes sums[3] = {};
        Eigen::Index k = 0;
        for (; k + width <= depth; k += width)
            for (int c = 0; c < 3; ++c)
                sums[c] += load(row + k) * load(columns.data + c * columns.stride + k);
        for (int c = 0; c < 3; ++c)
        {
            result[c] = total(sums[c]);
            for (Eigen::Index rest = k; rest < depth; ++rest)
                result[c] += row[rest] * columns.data[c * columns.stride + rest];
        }
    }

    static SHEETMORPH_INLINE void multiply(const Weights& left, const Rows& columns, Points& result)
    {
        for (Eigen::Index i = 0; i < left.rows(); ++i)
            multiply(left.data() + i * left.cols(), columns, left.cols(), result.data() + 3 * i);
    }
};

// Rows first .. of `right` side by side, zeros where there are none.
void pack(const WeightsView& right, Eigen::Index first, int columns, double* panel)
{
    std::fill(panel, panel + columns * right.cols(), 0.0);
    const Eigen::Index count = std::min<Eigen::Index>(columns, right.rows() - first);
    for (Eigen::Index c = 0; c < count; ++c)
        for (Eigen::Index k = 0; k < right.cols(); ++k)
            panel[columns * k + c] = right(first + c, k);
}

// In tiles of 2 * width columns.
template <int width>
SHEETMORPH_INLINE void add_tiles(const WeightsView& left, const WeightsView& right, double factor,
                                 WeightsTarget& result)
{
    constexpr int across = 2 * width;
    const Eigen::Index depth = left.cols(), rows = left.rows(), columns = right.rows();
    thread_local std::vector<double> panel;
    panel.resize(std::max(panel.size(), static_cast<std::size_t>(across * depth)));
    Tile tile{{}, panel.data(), depth, factor, {}, false, {}};
    for (Eigen::Index j = 0; j < columns; j += across)
    {
        pack(right, j, across, panel.data());
        const Eigen::Index wide = std::min<Eigen::Index>(across, columns - j);
        for (Eigen::Index i = 0; i < rows; i += tile_rows)
        {
            const Eigen::Index high = std::min<Eigen::Index>(tile_rows, rows - i);
            tile.is_whole = high == tile_rows && wide == across;
            for (Eigen::Index r = 0; r < tile_rows; ++r)
            {
                const Eigen::Index row = std::min(i + r, rows - 1);
                tile.left[r] = left.data() + row * left.outerStride();
                tile.result[r] = result.data() + row * result.outerStride() + j;
            }
            Kernel<width>::multiply(tile);
            for (Eigen::Index r = 0; r < high && !tile.is_whole; ++r)
                for (Eigen::Index c = 0; c < wide; ++c)
                    tile.result[r][c] += tile.sums[r][c];
        }
    }
}

}  // namespace

void add_product(const WeightsView& left, const WeightsView& right, double factor,
                 WeightsTarget result)
{
    if (left.cols() == 0)
        return;
    run_widest([&](auto width) SHEETMORPH_INLINED
               { add_tiles<width>(left, right, factor, result); });
}

void add_lower_product(const WeightsView& left, const WeightsView& right, double factor,
                       WeightsTarget result)
{
    constexpr Eigen::Index strip = 3 * largest_panel;
    for (Eigen::Index j = 0; j < result.cols(); j += strip)
    {
        const Eigen::Index wide = std::min(strip, result.cols() - j), high = result.rows() - j;
        add_product(left.bottomRows(high), right.middleRows(j, wide), factor,
                    result.block(j, j, high, wide));
    }
}

Points narrow_product(const Weights& left, const Points& right)
{
    Points result = Points::Zero(left.rows(), 3);
    if (left.cols() == 0)
        return result;
    const Weights columns = right.transpose();
    const Rows rows{columns.data(), columns.cols()};
    run_widest([&](auto width) SHEETMORPH_INLINED
               { Kernel<std::min<int>(width, narrow)>::multiply(left, rows, result); });
    return result;
}

}  // namespace sheetmorph::numerics

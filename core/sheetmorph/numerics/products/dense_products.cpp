// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/dense_products.h"

#include "sheetmorph/base/instructions/instructions.h"

#include <algorithm>
#include <vector>

#define HWY_TARGET_INCLUDE "sheetmorph/numerics/products/dense_products.cpp"
#include <hwy/foreach_target.h>

#include "sheetmorph/base/instructions/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace sheetmorph::numerics
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

// From the processor: six rows of two registers are twelve sums; of the 16 registers of AVX2 two
// hold the panel and one the entry of a row.
constexpr int tile_rows = 6;

// A tile of the product: tile_rows rows of `left` against a packed panel of 2 * width columns.
struct Tile : sheetmorph::HWY_NAMESPACE::LaneFunctions
{
    const double* left[tile_rows];
    const double* panel;  // (depth, 2 * width)
    Eigen::Index depth;
    double factor;
    double* result[tile_rows];  // whole tiles are added here, others stay in `sums`
    bool is_whole;
    double sums[tile_rows][2 * width];

    HWY_INLINE void multiply()
    {
        Lanes products[tile_rows][2];
        for (auto& row : products)
            row[0] = row[1] = filled(0.0);
        for (Eigen::Index k = 0; k < depth; ++k)
        {
            const Lanes first = load(panel + 2 * width * k);
            const Lanes second = load(panel + 2 * width * k + width);
            for (int r = 0; r < tile_rows; ++r)
            {
                const Lanes entry = filled(left[r][k]);
                products[r][0] = hn::MulAdd(entry, first, products[r][0]);
                products[r][1] = hn::MulAdd(entry, second, products[r][1]);
            }
        }
        for (int r = 0; r < tile_rows; ++r)
            for (int half = 0; half < 2; ++half)
            {
                double* const to = (is_whole ? result[r] : sums[r]) + half * width;
                const Lanes product = products[r][half];
                store(is_whole ? hn::MulAdd(filled(factor), product, load(to))
                               : filled(factor) * product,
                      to);
            }
    }
};

// Products with three columns. The final sums of wider registers would take longer than they save.
struct ThreeColumns
{
    using Narrow = hn::CappedTag<double, 4>;
    static constexpr Eigen::Index width = hn::MaxLanes(Narrow());

    // The sum plus all lanes, in order.
    template <class D>
    static HWY_INLINE double added(double sum, D lanes, hn::Vec<D> value)
    {
        if constexpr (hn::MaxLanes(lanes) == 1)
            return sum + GetLane(value);
        else
        {
            const hn::Half<D> half;
            return added(added(sum, half, LowerHalf(half, value)), half, UpperHalf(half, value));
        }
    }

    // `row` times three columns, each contiguous.
    static HWY_INLINE void multiply(const double* row, const Weights& columns, double* result)
    {
        const Eigen::Index depth = columns.cols();
        hn::Vec<Narrow> sums[3];
        for (auto& sum : sums)
            sum = hn::Zero(Narrow());
        Eigen::Index k = 0;
        for (; k + width <= depth; k += width)
            for (int c = 0; c < 3; ++c)
                sums[c] = hn::MulAdd(hn::LoadU(Narrow(), row + k),
                                     hn::LoadU(Narrow(), columns.data() + c * depth + k), sums[c]);
        for (int c = 0; c < 3; ++c)
        {
            double sum = added(0.0, Narrow(), sums[c]);
            for (Eigen::Index rest = k; rest < depth; ++rest)
                sum += row[rest] * columns(c, rest);
            result[c] = sum;
        }
    }
};

// Packs rows of `right`, from `first` on, side by side; fills up with zeros.
void pack(const WeightsView& right, Eigen::Index first, int columns, double* panel)
{
    std::fill(panel, panel + columns * right.cols(), 0.0);
    const Eigen::Index count = std::min<Eigen::Index>(columns, right.rows() - first);
    for (Eigen::Index c = 0; c < count; ++c)
        for (Eigen::Index k = 0; k < right.cols(); ++k)
            panel[columns * k + c] = right(first + c, k);
}

// Multiplies in tiles of 2 * width columns.
void add_product_widest(const WeightsView& left, const WeightsView& right, double factor,
                        WeightsTarget& result)
{
    constexpr int across = 2 * Tile::width;  // from the tile
    const Eigen::Index depth = left.cols(), rows = left.rows(), columns = right.rows();
    thread_local std::vector<double> panel;
    panel.resize(std::max(panel.size(), static_cast<std::size_t>(across * depth)));
    Tile tile{{}, {}, panel.data(), depth, factor, {}, false, {}};
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
            tile.multiply();
            for (Eigen::Index r = 0; r < high && !tile.is_whole; ++r)
                for (Eigen::Index c = 0; c < wide; ++c)
                    tile.result[r][c] += tile.sums[r][c];
        }
    }
}

void narrow_product_widest(const Weights& left, const Weights& columns, Points& result)
{
    for (Eigen::Index i = 0; i < left.rows(); ++i)
        ThreeColumns::multiply(left.data() + i * left.cols(), columns, result.data() + 3 * i);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph::numerics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheetmorph::numerics
{

HWY_EXPORT(add_product_widest);
HWY_EXPORT(narrow_product_widest);

void add_product(const WeightsView& left, const WeightsView& right, double factor,
                 WeightsTarget result)
{
    if (left.cols() > 0)
        SHEETMORPH_WIDEST(add_product_widest)(left, right, factor, result);
}

void add_lower_product(const WeightsView& left, const WeightsView& right, double factor,
                       WeightsTarget result)
{
    constexpr Eigen::Index strip = 48;  // from the tiles: a multiple of every width
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
    if (left.cols() > 0)
        SHEETMORPH_WIDEST(narrow_product_widest)(left, right.transpose(), result);
    return result;
}

}  // namespace sheetmorph::numerics
#endif

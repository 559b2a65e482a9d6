// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/panel_rows.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/instructions/widest.h"

#include <algorithm>
#include <cstring>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph::numerics
{

namespace
{

constexpr int panel = 8;  // rows

//! The panels of a matrix; without the rests of the entries where they need not be exact.
struct Panels
{
    const float* first;
    const float* rest;

    Panels from(Eigen::Index entry) const { return {first + entry, rest ? rest + entry : nullptr}; }
};

template <int width, bool is_whole>
struct Kernel
{
    using Lanes = typename VectorTypes<width>::Lanes;
    typedef float Floats __attribute__((vector_size(width * sizeof(float))));

    static constexpr int parts = panel / width;  // of a column of a panel

    // Twelve sums are under way at once.
    static constexpr int together = 4 / parts;

    static SHEETMORPH_INLINE Lanes widened(const float* entries)
    {
        Floats some;
        std::memcpy(&some, entries, sizeof some);
        return __builtin_convertvector(some, Lanes);
    }

    // \param entries  of some panels, `stride` entries apart
    template <int panels>
    static SHEETMORPH_INLINE void multiply(const Panels& entries, Eigen::Index stride,
                                           const Points& right, double (*result)[3][panel])
    {
        Lanes sums[panels][parts][3] = {};
        for (Eigen::Index k = 0; k < right.rows(); ++k)
            for (int p = 0; p < panels; ++p)
                for (int part = 0; part < parts; ++part)
                {
                    const Eigen::Index at = p * stride + panel * k + part * width;
                    Lanes entry = widened(entries.first + at);
                    if constexpr (is_whole)
                        entry += widened(entries.rest + at);
                    for (int c = 0; c < 3; ++c)
                        sums[p][part][c] += entry * right.data()[3 * k + c];
                }
        for (int p = 0; p < panels; ++p)
            for (int part = 0; part < parts; ++part)
                for (int c = 0; c < 3; ++c)
                    std::memcpy(result[p][c] + part * width, &sums[p][part][c], sizeof(Lanes));
    }

    static SHEETMORPH_INLINE void multiply(const Panels& entries, const Points& right,
                                           Points& result)
    {
        const Eigen::Index count = result.rows(), stride = panel * right.rows();
        for (Eigen::Index row = 0; row < count; row += together * panel)
        {
            double sums[together][3][panel];
            const Panels from = entries.from(row * right.rows());
            if (row + (together - 1) * panel < count)
                multiply<together>(from, stride, right, sums);
            else
                for (int p = 0; row + p * panel < count; ++p)
                    multiply<1>(from.from(p * stride), stride, right, sums + p);
            const auto some = std::min<Eigen::Index>(together * panel, count - row);
            for (Eigen::Index k = 0; k < some; ++k)
                for (int c = 0; c < 3; ++c)
                    result(row + k, c) = sums[k / panel][c][k % panel];
        }
    }
};

}  // namespace

PanelRows::PanelRows(Eigen::Index rows, Eigen::Index columns)
    : rows_(rows),
      columns_(columns),
      first_(at((rows + panel - 1) / panel * columns)),
      rest_(first_.size())
{
}

PanelRows::PanelRows(const Weights& rows) : PanelRows(rows.rows(), rows.cols())
{
    set(0, rows);
}

void PanelRows::set(Eigen::Index first, const Weights& rows)
{
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
    {
        const std::size_t to = at((first + row) / panel * columns_);
        const auto lane = at((first + row) % panel);
        for (Eigen::Index k = 0; k < columns_; ++k)
        {
            float& most = first_[to + at(k)].at[lane];
            most = static_cast<float>(rows(row, k));
            rest_[to + at(k)].at[lane] = static_cast<float>(rows(row, k) - most);
        }
    }
}

Points PanelRows::times(const Points& right, Exactness exactness) const
{
    Points result(rows_, 3);
    if (first_.empty())
        result.setZero();
    else if (exactness == Exactness::exact)
        run_widest(
            [&](auto width) SHEETMORPH_INLINED {
                Kernel<width, true>::multiply({first_.data()->at, rest_.data()->at}, right, result);
            });
    else
        run_widest(
            [&](auto width) SHEETMORPH_INLINED {
                Kernel<width, false>::multiply({first_.data()->at, nullptr}, right, result);
            });
    return result;
}

}  // namespace sheetmorph::numerics

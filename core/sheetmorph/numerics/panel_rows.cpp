// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/panel_rows.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/instructions/widest.h"

#include <algorithm>
#include <cstring>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph
{

namespace
{

constexpr int panel = 8;  // rows

template <int width>
struct Kernel
{
    using Lanes = typename VectorTypes<width>::Lanes;

    static constexpr int parts = panel / width;  // of a column of a panel

    // Twelve sums are under way at once.
    static constexpr int together = 4 / parts;

    // \param entries  of some panels, `stride` doubles apart
    template <int panels>
    static SHEETMORPH_INLINE void multiply(const double* entries, Eigen::Index stride,
                                           const Points& right, double (*result)[3][panel])
    {
        Lanes sums[panels][parts][3] = {};
        for (Eigen::Index k = 0; k < right.rows(); ++k)
            for (int p = 0; p < panels; ++p)
                for (int part = 0; part < parts; ++part)
                {
                    Lanes entry;
                    std::memcpy(&entry, entries + p * stride + panel * k + part * width,
                                sizeof entry);
                    for (int c = 0; c < 3; ++c)
                        sums[p][part][c] += entry * right.data()[3 * k + c];
                }
        for (int p = 0; p < panels; ++p)
            for (int part = 0; part < parts; ++part)
                for (int c = 0; c < 3; ++c)
                    std::memcpy(result[p][c] + part * width, &sums[p][part][c], sizeof(Lanes));
    }

    static SHEETMORPH_INLINE void multiply(const double* entries, const Points& right,
                                           Points& result)
    {
        const Eigen::Index count = result.rows(), stride = panel * right.rows();
        for (Eigen::Index row = 0; row < count; row += together * panel)
        {
            double sums[together][3][panel];
            const double* const from = entries + row * right.rows();
            if (row + (together - 1) * panel < count)
                multiply<together>(from, stride, right, sums);
            else
                for (int p = 0; row + p * panel < count; ++p)
                    multiply<1>(from + p * stride, stride, right, sums + p);
            const auto some = std::min<Eigen::Index>(together * panel, count - row);
            for (Eigen::Index k = 0; k < some; ++k)
                for (int c = 0; c < 3; ++c)
                    result(row + k, c) = sums[k / panel][c][k % panel];
        }
    }
};

}  // namespace

PanelRows::PanelRows(Eigen::Index rows, Eigen::Index columns)
    : rows_(rows), columns_(columns), entries_(at((rows + panel - 1) / panel * columns))
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
        Entries* const to = entries_.data() + (first + row) / panel * columns_;
        for (Eigen::Index k = 0; k < columns_; ++k)
            to[k].at[(first + row) % panel] = rows(row, k);
    }
}

Points PanelRows::times(const Points& right) const
{
    Points result(rows_, 3);
    if (columns_ == 0)
        result.setZero();
    else
        run_widest([&](auto width) SHEETMORPH_INLINED
                   { Kernel<width>::multiply(entries_.data()->at, right, result); });
    return result;
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/products/panel_rows.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/instructions/instructions.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#define HWY_TARGET_INCLUDE "sheetmorph/numerics/products/panel_rows.cpp"
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

constexpr int panel = 8;  // rows; from the widest register, eight doubles

// From the formats: a float in [2^e, 2^(e+1)) is at most 2^(e-24) from its entry. That is 2^15
// units of 2^(e-39), so 16 bits hold the remainder.
constexpr float unit_share = 1.0F / (1LL << 39);
constexpr std::int32_t exponent_bits = 0x7f800000;

//! The panels of a matrix; without the remainders for live products.
template <typename Remainder>
struct Panels
{
    const float* first;
    const Remainder* rest;

    Panels from(Eigen::Index entry) const { return {first + entry, rest ? rest + entry : nullptr}; }
};

template <typename Remainder, bool is_whole>
struct Kernel : sheetmorph::HWY_NAMESPACE::LaneFunctions
{
    using Floats = hn::Rebind<float, Doubles>;

    static constexpr int parts = panel / width;  // of a column of a panel

    // From the processor, as in dense_products.cpp: twelve sums run at once, or those of one panel.
    static constexpr int together = std::max(1, 4 / parts);

    static HWY_INLINE Lanes widened(const float* entries)
    {
        return hn::PromoteTo(Doubles(), hn::LoadU(Floats(), entries));
    }

    static HWY_INLINE Lanes widened(const float* /*entries*/, const float* rests)
    {
        return widened(rests);
    }

    // Exact, because the factors are powers of two and numbers of 16 bits.
    static HWY_INLINE Lanes widened(const float* entries, const std::int16_t* rests)
    {
        const hn::Rebind<std::int16_t, Doubles> shorts;
        const hn::Rebind<std::int32_t, Doubles> integers;
        const auto bits = hn::BitCast(integers, hn::LoadU(Floats(), entries));
        const auto powers = hn::BitCast(Floats(), hn::And(bits, hn::Set(integers, exponent_bits)));
        const auto counts = hn::PromoteTo(integers, hn::LoadU(shorts, rests));
        const auto units = hn::ConvertTo(Floats(), counts) * hn::Set(Floats(), unit_share);
        return hn::PromoteTo(Doubles(), powers * units);
    }

    // \param entries  of several panels, `stride` entries apart
    template <int panels>
    static HWY_INLINE void multiply(const Panels<Remainder>& entries, Eigen::Index stride,
                                    const Points& right, double (*result)[3][panel])
    {
        Lanes sums[panels][parts][3];
        for (auto& of_panel : sums)
            for (auto& of_part : of_panel)
                of_part[0] = of_part[1] = of_part[2] = filled(0.0);
        for (Eigen::Index k = 0; k < right.rows(); ++k)
            for (int p = 0; p < panels; ++p)
                for (int part = 0; part < parts; ++part)
                {
                    const Eigen::Index at = p * stride + panel * k + part * width;
                    Lanes entry = widened(entries.first + at);
                    if constexpr (is_whole)
                        entry = entry + widened(entries.first + at, entries.rest + at);
                    for (int c = 0; c < 3; ++c)
                        sums[p][part][c] =
                            hn::MulAdd(entry, filled(right.data()[3 * k + c]), sums[p][part][c]);
                }
        for (int p = 0; p < panels; ++p)
            for (int part = 0; part < parts; ++part)
                for (int c = 0; c < 3; ++c)
                    store(sums[p][part][c], result[p][c] + part * width);
    }

    static HWY_INLINE void multiply(const Panels<Remainder>& entries, const Points& right,
                                    Points& result)
    {
        const Eigen::Index count = result.rows(), stride = panel * right.rows();
        for (Eigen::Index row = 0; row < count; row += together * panel)
        {
            double sums[together][3][panel];
            const Panels<Remainder> from = entries.from(row * right.rows());
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

// \param rest  nullptr for a live product
template <typename Remainder>
void multiply(const float* first, const Remainder* rest, const Points& right, Points& result)
{
    if (rest != nullptr)
        Kernel<Remainder, true>::multiply({first, rest}, right, result);
    else
        Kernel<Remainder, false>::multiply({first, rest}, right, result);
}

void multiply_exact_rows(const float* first, const float* rest, const Points& right, Points& result)
{
    multiply(first, rest, right, result);
}

void multiply_compact_rows(const float* first, const std::int16_t* rest, const Points& right,
                           Points& result)
{
    multiply(first, rest, right, result);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph::numerics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheetmorph::numerics
{

namespace
{

using HWY_NAMESPACE::exponent_bits;
using HWY_NAMESPACE::panel;
using HWY_NAMESPACE::unit_share;

double power_of_bits(std::int32_t bits)
{
    float power;
    std::memcpy(&power, &bits, sizeof power);
    return power;
}

// Both store `rest`, the difference between an entry and the float `most`, and return the rounding
// error.
double keep(double rest, float /*most*/, float& remainder)
{
    remainder = static_cast<float>(rest);
    return 0.0;  // negligible against the rounding of a product
}

// Avoids a division: the exponent bits of a power of two, subtracted from those of 1 squared, are
// those of its inverse.
double keep(double rest, float most, std::int16_t& remainder)
{
    constexpr std::int32_t inverse_bits = 0x7f000000;
    constexpr double largest = std::numeric_limits<std::int16_t>::max();
    std::int32_t bits;
    std::memcpy(&bits, &most, sizeof bits);
    bits &= exponent_bits;
    const double unit = power_of_bits(bits) * unit_share;
    const double inverse = bits == 0 ? 0.0 : power_of_bits(inverse_bits - bits) / unit_share;
    const double units = std::clamp(rest * inverse, -largest, largest);
    remainder = static_cast<std::int16_t>(units + (units < 0.0 ? -0.5 : 0.5));
    return rest - remainder * unit;
}

}  // namespace

HWY_EXPORT(multiply_exact_rows);
HWY_EXPORT(multiply_compact_rows);

template <typename Remainder>
PanelRows<Remainder>::PanelRows(Eigen::Index rows, Eigen::Index columns)
    : rows_(rows),
      columns_(columns),
      first_(at((rows + panel - 1) / panel * columns)),
      rest_(first_.size())
{
}

template <typename Remainder>
PanelRows<Remainder>::PanelRows(const Weights& rows) : PanelRows(rows.rows(), rows.cols())
{
    set(0, rows);
}

// The next remainder of a row absorbs the rounding error of the one before. A product with numbers
// that vary little from entry to entry is then more exact than the entries.
template <typename Remainder>
void PanelRows<Remainder>::set(Eigen::Index first, const Weights& rows)
{
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
    {
        const std::size_t to = at((first + row) / panel * columns_);
        const auto lane = at((first + row) % panel);
        double left = 0.0;
        for (Eigen::Index k = 0; k < columns_; ++k)
        {
            float& most = first_[to + at(k)].at[lane];
            Remainder& remainder = rest_[to + at(k)].at[lane];
            most = static_cast<float>(rows(row, k));
            left = keep(rows(row, k) - most + left, most, remainder);
        }
    }
}

template <typename Remainder>
Points PanelRows<Remainder>::times(const Points& right, Exactness exactness) const
{
    Points result = Points::Zero(rows_, 3);
    if (first_.empty())
        return result;
    const Remainder* const rest = exactness == Exactness::exact ? rest_.data()->at : nullptr;
    if constexpr (std::is_same_v<Remainder, float>)
        SHEETMORPH_WIDEST(multiply_exact_rows)(first_.data()->at, rest, right, result);
    else
        SHEETMORPH_WIDEST(multiply_compact_rows)(first_.data()->at, rest, right, result);
    return result;
}

template class PanelRows<float>;
template class PanelRows<std::int16_t>;

}  // namespace sheetmorph::numerics
#endif

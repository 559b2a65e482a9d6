// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response/response_kernel.h"

#include "sheetmorph/base/instructions/instructions.h"

#define HWY_TARGET_INCLUDE "sheetmorph/numerics/response/response_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sheetmorph::numerics
{
namespace HWY_NAMESPACE
{
namespace
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;
constexpr int width = static_cast<int>(hn::MaxLanes(Floats()));

// From the processor: it starts two multiply-adds per cycle and ends each after four, so eight
// independent sums keep it busy. Three vectors of x, y and z are nine.
constexpr int vectors = 3;

using Blended = float[ResponseProduct::most_fields][3];

using Group = hn::CappedTag<float, ResponseProduct::lanes>;

HWY_INLINE void add_column(const float* share, const double* coefficients,
                           hn::Vec<Group> (&sums)[3])
{
    for (int axis = 0; axis < 3; ++axis)
        sums[axis] =
            hn::MulAdd(hn::LoadU(Group(), share),
                       hn::Set(Group(), static_cast<float>(coefficients[axis])), sums[axis]);
}

// shares * coefficients. Two sums per axis hide the latency of an addition.
HWY_INLINE void blend(const ResponseProduct& work, Blended& blended)
{
    constexpr int lanes = ResponseProduct::lanes;
    constexpr int group_width = static_cast<int>(hn::MaxLanes(Group()));
    const int count = work.wide_count + work.narrow_count;
    const long step = (count + lanes - 1) / lanes * lanes;
    for (int group = 0; group < count; group += group_width)
    {
        hn::Vec<Group> sums[2][3];
        for (auto& sum : sums)
            sum[0] = sum[1] = sum[2] = hn::Zero(Group());
        const float* share = work.shares + group;
        const double* c = work.coefficients;
        int k = 0;
        for (; k + 2 <= work.columns; k += 2, c += 6, share += 2 * step)
            for (int one = 0; one < 2; ++one)
                add_column(share + one * step, c + 3 * one, sums[one]);
        if (k < work.columns)
            add_column(share, c, sums[0]);
        for (int axis = 0; axis < 3; ++axis)
        {
            float sum[group_width];
            hn::StoreU(sums[0][axis] + sums[1][axis], Group(), sum);
            for (int lane = 0; lane < group_width; ++lane)
                blended[group + lane][axis] = sum[lane];
        }
    }
}

HWY_INLINE void add_field(const float* blended, Lanes rows, Lanes (&sums)[3])
{
    for (int axis = 0; axis < 3; ++axis)
        sums[axis] = hn::MulAdd(rows, hn::Set(Floats(), blended[axis]), sums[axis]);
}

HWY_INLINE void store(const Lanes (&sums)[3], double* result)
{
    using Doubles = hn::CappedTag<double, 8>;
    const hn::Rebind<float, Doubles> half;
    constexpr int step = static_cast<int>(hn::MaxLanes(Doubles()));
    float rows[3 * width];
    hn::StoreInterleaved3(sums[0], sums[1], sums[2], Floats(), rows);
    for (int k = 0; k < 3 * width; k += step)
        hn::StoreU(hn::PromoteTo(Doubles(), hn::LoadU(half, rows + k)), Doubles(), result + k);
}

// Multiplies rows of one block, from `first` on.
HWY_INLINE void multiply_rows(const ResponseProduct& work, const Blended& blended, long block,
                              int first)
{
    const hn::Rebind<std::int16_t, Floats> shorts;
    const hn::Rebind<std::int32_t, Floats> integers;
    Lanes sums[vectors][3];  // x, y, z
    for (auto& sum : sums)
        sum[0] = sum[1] = sum[2] = hn::Zero(Floats());
    const ResponseRows* wide = work.wide + block * work.wide_count;
    for (int k = 0; k < work.wide_count; ++k)
        for (int v = 0; v < vectors; ++v)
            add_field(blended[k], hn::LoadU(Floats(), wide[k].at + first + v * width), sums[v]);
    const NarrowRows* narrow = work.narrow + block * work.narrow_count;
    for (int k = 0; k < work.narrow_count; ++k)
        for (int v = 0; v < vectors; ++v)
        {
            const auto steps = hn::LoadU(shorts, narrow[k].at + first + v * width);
            add_field(blended[work.wide_count + k],
                      hn::ConvertTo(Floats(), hn::PromoteTo(integers, steps)), sums[v]);
        }
    for (int v = 0; v < vectors; ++v)
        store(sums[v], work.result + 3 * (block * ResponseRows::count + first + v * width));
}

void run_widest(const ResponseProduct& work)
{
    static_assert(ResponseRows::count % (vectors * width) == 0);
    Blended blended;
    blend(work, blended);
    for (long block = 0; block < work.blocks; ++block)
        for (int first = 0; first < ResponseRows::count; first += vectors * width)
            multiply_rows(work, blended, block, first);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph::numerics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheetmorph::numerics
{

HWY_EXPORT(run_widest);

void run_response_kernel(const ResponseProduct& work)
{
    SHEETMORPH_WIDEST(run_widest)(work);
}

}  // namespace sheetmorph::numerics
#endif

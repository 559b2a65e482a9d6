// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response/response_kernel.h"

#include "sheetmorph/base/instructions/widest.h"

#include <utility>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph::numerics
{

namespace
{

// Vectors in memory, at any address.
template <typename Lanes>
struct Unaligned
{
    Lanes value;
} __attribute__((packed, may_alias));

template <typename Lanes, typename Number>
SHEETMORPH_INLINE Lanes load(const Number* from)
{
    return reinterpret_cast<const Unaligned<Lanes>*>(from)->value;
}

// The kernel for processors that compute `width` floats at once.
template <int width>
struct Kernel
{
    using Types = FloatVectorTypes<width>;
    using Lanes = typename Types::Lanes;
    using Doubles = typename VectorTypes<width / 2>::Lanes;
    using Sequence = std::make_integer_sequence<int, width>;
    using Half = std::make_integer_sequence<int, width / 2>;
    using Group = typename FloatVectorTypes<ResponseProduct::lanes>::Lanes;

    // Nine sums are under way at once: enough to hide how long one multiply-add takes.
    static constexpr int vectors = 3;

    struct Sums
    {
        Lanes x[vectors], y[vectors], z[vectors];
    };
    using Blended = float[ResponseProduct::most_fields][3];

    // Entry 3 i + axis of x0 y0 z0 x1 ... is what `part` holds at its lane `lane`: first x and y
    // are merged, then z comes in.
    static constexpr int flat(int part, int lane) { return part * width + lane; }
    static constexpr int merged(int part, int lane)
    {
        const int row = flat(part, lane) / 3, axis = flat(part, lane) % 3;
        return axis == 1 ? width + row : row;
    }
    static constexpr int completed(int part, int lane)
    {
        const int row = flat(part, lane) / 3, axis = flat(part, lane) % 3;
        return axis == 2 ? width + row : lane;
    }

    template <int part, int... lane>
    static SHEETMORPH_INLINE Lanes interleaved(const Sums& sums, int v,
                                               std::integer_sequence<int, lane...>)
    {
        const Lanes both = __builtin_shufflevector(sums.x[v], sums.y[v], merged(part, lane)...);
        return __builtin_shufflevector(both, sums.z[v], completed(part, lane)...);
    }

    template <int first, int... lane>
    static SHEETMORPH_INLINE void store_half(const Lanes& sum, double* result,
                                             std::integer_sequence<int, lane...>)
    {
        const auto half = __builtin_shufflevector(sum, sum, (first + lane)...);
        reinterpret_cast<Unaligned<Doubles>*>(result + first)->value =
            __builtin_convertvector(half, Doubles);
    }

    template <int part>
    static SHEETMORPH_INLINE void store(const Sums& sums, int v, double* result)
    {
        const int offset = (3 * v + part) * width;
        const Lanes sum = interleaved<part>(sums, v, Sequence());
        store_half<0>(sum, result + offset, Half());
        store_half<width / 2>(sum, result + offset, Half());
    }

    // shares * coefficients: two sums an axis hide how long one takes.
    static SHEETMORPH_INLINE void blend(const ResponseProduct& work, Blended& blended)
    {
        constexpr int lanes = ResponseProduct::lanes;
        const int count = work.wide_count + work.narrow_count;
        const long step = (count + lanes - 1) / lanes * lanes;
        for (int group = 0; group < count; group += lanes)
        {
            Group sums[2][3] = {};
            const float* share = work.shares + group;
            const double* c = work.coefficients;
            int k = 0;
            for (; k + 2 <= work.columns; k += 2, c += 6, share += 2 * step)
                for (int one = 0; one < 2; ++one)
                    for (int axis = 0; axis < 3; ++axis)
                        sums[one][axis] +=
                            load<Group>(share + one * step) * static_cast<float>(c[3 * one + axis]);
            for (int axis = 0; k < work.columns && axis < 3; ++axis)
                sums[0][axis] += load<Group>(share) * static_cast<float>(c[axis]);
            for (int axis = 0; axis < 3; ++axis)
            {
                const Group sum = sums[0][axis] + sums[1][axis];
                for (int lane = 0; lane < lanes; ++lane)
                    blended[group + lane][axis] = sum[lane];
            }
        }
    }

    static SHEETMORPH_INLINE void add_field(const float* blended, const Lanes& rows, int v,
                                            Sums& sums)
    {
        sums.x[v] += rows * blended[0];
        sums.y[v] += rows * blended[1];
        sums.z[v] += rows * blended[2];
    }

    // Rows `first` .. of one block.
    static SHEETMORPH_INLINE void rows(const ResponseProduct& work, const Blended& blended,
                                       long block, int first)
    {
        Sums sums = {};
        const ResponseRows* wide = work.wide + block * work.wide_count;
        for (int k = 0; k < work.wide_count; ++k)
            for (int v = 0; v < vectors; ++v)
                add_field(blended[k], load<Lanes>(wide[k].at + first + v * width), v, sums);
        const NarrowRows* narrow = work.narrow + block * work.narrow_count;
        for (int k = 0; k < work.narrow_count; ++k)
            for (int v = 0; v < vectors; ++v)
            {
                const auto steps = load<typename Types::Shorts>(narrow[k].at + first + v * width);
                add_field(blended[work.wide_count + k], __builtin_convertvector(steps, Lanes), v,
                          sums);
            }
        const long offset = 3 * (block * ResponseRows::count + first);
        for (int v = 0; v < vectors; ++v)
        {
            store<0>(sums, v, work.result + offset);
            store<1>(sums, v, work.result + offset);
            store<2>(sums, v, work.result + offset);
        }
    }

    static SHEETMORPH_INLINE void run(const ResponseProduct& work)
    {
        static_assert(ResponseRows::count % (vectors * width) == 0);
        Blended blended;
        blend(work, blended);
        for (long block = 0; block < work.blocks; ++block)
            for (int first = 0; first < ResponseRows::count; first += vectors * width)
                rows(work, blended, block, first);
    }
};

}  // namespace

void run_response_kernel(const ResponseProduct& work)
{
    run_widest([&](auto width) SHEETMORPH_INLINED { Kernel<2 * width>::run(work); });
}

}  // namespace sheetmorph::numerics

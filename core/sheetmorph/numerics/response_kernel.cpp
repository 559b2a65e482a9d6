// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response_kernel.h"

#include "sheetmorph/base/vector_types.h"

#include <cstring>
#include <utility>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph
{

namespace
{

// The kernel for processors that compute `width` floats at once.
template <int width>
struct Kernel
{
    using Lanes = typename FloatVectorTypes<width>::Lanes;
    using Doubles = typename FloatVectorTypes<width>::Doubles;
    using Sequence = std::make_integer_sequence<int, width>;

    // Nine sums are under way at once: enough to hide how long one multiply-add takes.
    static constexpr int vectors = 3;

    struct Sums
    {
        Lanes x[vectors], y[vectors], z[vectors];
    };

    static SHEETMORPH_INLINE Lanes load(const float* from)
    {
        Lanes value;
        std::memcpy(&value, from, sizeof value);
        return value;
    }

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

    template <int part>
    static SHEETMORPH_INLINE void add(const Sums& sums, int v, const double* start, double* result)
    {
        const int offset = (3 * v + part) * width;
        Doubles value;
        std::memcpy(&value, start + offset, sizeof value);
        value += __builtin_convertvector(interleaved<part>(sums, v, Sequence()), Doubles);
        std::memcpy(result + offset, &value, sizeof value);
    }

    // Rows `first` .. of one block; start and result are those of the block.
    static SHEETMORPH_INLINE void rows(const ResponseBlocks& work, long block, int first)
    {
        Sums sums = {};
        const ResponseRows* column = work.basis + block * work.columns;
        const float* c = work.coefficients;
        for (int k = 0; k < work.columns; ++k, ++column, c += 3)
            for (int v = 0; v < vectors; ++v)
            {
                const Lanes basis = load(column->at + first + v * width);
                sums.x[v] += basis * c[0];
                sums.y[v] += basis * c[1];
                sums.z[v] += basis * c[2];
            }
        const long offset = 3 * (block * ResponseRows::count + first);
        for (int v = 0; v < vectors; ++v)
        {
            add<0>(sums, v, work.start + offset, work.result + offset);
            add<1>(sums, v, work.start + offset, work.result + offset);
            add<2>(sums, v, work.start + offset, work.result + offset);
        }
    }

    static SHEETMORPH_INLINE void run(const ResponseBlocks& work)
    {
        static_assert(ResponseRows::count % (vectors * width) == 0);
        for (long block = 0; block < work.blocks; ++block)
            for (int first = 0; first < ResponseRows::count; first += vectors * width)
                rows(work, block, first);
    }
};

__attribute__((target("avx512f,avx512vl,avx512dq,fma,prefer-vector-width=512"))) void kernel_512(
    const ResponseBlocks& work)
{
    Kernel<16>::run(work);
}

__attribute__((target("avx2,fma"))) void kernel_256(const ResponseBlocks& work)
{
    Kernel<8>::run(work);
}

void kernel_128(const ResponseBlocks& work)
{
    Kernel<4>::run(work);
}

}  // namespace

void run_response_kernel(const ResponseBlocks& work)
{
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
        kernel_512(work);
    else if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        kernel_256(work);
    else
        kernel_128(work);
}

}  // namespace sheetmorph

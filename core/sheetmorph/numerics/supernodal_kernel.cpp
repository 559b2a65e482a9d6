// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/supernodal_kernel.h"

#include "sheetmorph/base/vector_types.h"

#include <cstring>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph
{

namespace
{

using Lanes = VectorTypes<right_sides_at_once>::Lanes;

SHEETMORPH_INLINE Lanes load(const double* w, int row)
{
    Lanes value;
    std::memcpy(&value, w + right_sides_at_once * row, sizeof value);
    return value;
}

SHEETMORPH_INLINE void store(const Lanes& value, double* w, int row)
{
    std::memcpy(w + right_sides_at_once * row, &value, sizeof value);
}

// Entries of `together` columns from `first` on.
template <int together>
struct Columns
{
    const double* at[together];

    SHEETMORPH_INLINE Columns(const Supernode& node, int first)
    {
        for (int c = 0; c < together; ++c)
            at[c] = node.entries + static_cast<long>(first + c) * node.rows;
    }

    SHEETMORPH_INLINE const double* operator[](int c) const { return at[c]; }
};

// `together` columns from `first` on: their own triangle, then every row below.
template <int together>
SHEETMORPH_INLINE void forward_columns(const Supernode& node, int first, double* w)
{
    const Columns<together> column(node, first);
    Lanes x[together];
    for (int c = 0; c < together; ++c)
    {
        x[c] = load(w, first + c);
        for (int d = 0; d < c; ++d)
            x[c] -= column[d][first + c] * x[d];
        x[c] /= column[c][first + c];
        store(x[c], w, first + c);
    }
    for (int row = first + together; row < node.rows; ++row)
    {
        Lanes sum = load(w, row);
        for (int c = 0; c < together; ++c)
            sum -= column[c][row] * x[c];
        store(sum, w, row);
    }
}

template <int together>
SHEETMORPH_INLINE void backward_columns(const Supernode& node, int first, double* w)
{
    const Columns<together> column(node, first);
    Lanes x[together];
    for (int c = 0; c < together; ++c)
        x[c] = load(w, first + c);
    for (int row = first + together; row < node.rows; ++row)
    {
        const Lanes known = load(w, row);
        for (int c = 0; c < together; ++c)
            x[c] -= column[c][row] * known;
    }
    for (int c = together - 1; c >= 0; --c)
    {
        for (int d = c + 1; d < together; ++d)
            x[c] -= column[c][first + d] * x[d];
        x[c] /= column[c][first + c];
        store(x[c], w, first + c);
    }
}

SHEETMORPH_INLINE void forward(const Supernode& node, double* w)
{
    int first = 0;
    for (; first + 8 <= node.columns; first += 8)
        forward_columns<8>(node, first, w);
    for (; first + 2 <= node.columns; first += 2)
        forward_columns<2>(node, first, w);
    if (first < node.columns)
        forward_columns<1>(node, first, w);
}

SHEETMORPH_INLINE void backward(const Supernode& node, double* w)
{
    int end = node.columns;
    for (; end % 2 != 0; --end)
        backward_columns<1>(node, end - 1, w);
    for (; end % 8 != 0; end -= 2)
        backward_columns<2>(node, end - 2, w);
    for (; end > 0; end -= 8)
        backward_columns<8>(node, end - 8, w);
}

__attribute__((target("avx2,fma"))) void forward_256(const Supernode& node, double* w)
{
    forward(node, w);
}

__attribute__((target("avx2,fma"))) void backward_256(const Supernode& node, double* w)
{
    backward(node, w);
}

bool has_256()
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

}  // namespace

void run_forward(const Supernode& node, double* w)
{
    if (has_256())
        forward_256(node, w);
    else
        forward(node, w);
}

void run_backward(const Supernode& node, double* w)
{
    if (has_256())
        backward_256(node, w);
    else
        backward(node, w);
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/front_kernel.h"

#include "sheetmorph/base/instructions/widest.h"

#include <cstring>

// Fused multiply-adds where the processor has them.
#pragma GCC optimize("fp-contract=fast")
// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph
{

namespace
{

// `together` rows of a front from `first` on.
template <int together>
struct Rows
{
    const double* at[together];

    SHEETMORPH_INLINE Rows(const Front& front, int first)
    {
        for (int r = 0; r < together; ++r)
            at[r] = front.entries.get() + static_cast<long>(first + r) * front.columns;
    }

    SHEETMORPH_INLINE const double* operator[](int r) const { return at[r]; }
};

// On `sides` right sides at once.
template <int sides>
struct Substitution
{
    using Lanes = typename VectorTypes<sides>::Lanes;

    static SHEETMORPH_INLINE Lanes load(const double* w, int row)
    {
        Lanes value;
        std::memcpy(&value, w + sides * row, sizeof value);
        return value;
    }

    static SHEETMORPH_INLINE void store(const Lanes& value, double* w, int row)
    {
        std::memcpy(w + sides * row, &value, sizeof value);
    }

    // Takes the part of the columns before `columns` off some rows.
    template <int together>
    static SHEETMORPH_INLINE void take_off(const Rows<together>& row, int columns, const double* w,
                                           Lanes (&sums)[together])
    {
        for (int c = 0; c < columns; ++c)
        {
            const Lanes x = load(w, c);
            for (int r = 0; r < together; ++r)
                sums[r] -= row[r][c] * x;
        }
    }

    template <int together>
    static SHEETMORPH_INLINE void forward_own(const Front& front, int first, double* w)
    {
        const Rows<together> row(front, first);
        Lanes x[together];
        for (int r = 0; r < together; ++r)
            x[r] = load(w, first + r);
        take_off(row, first, w, x);
        for (int r = 0; r < together; ++r)
        {
            for (int d = 0; d < r; ++d)
                x[r] -= row[r][first + d] * x[d];
            x[r] /= row[r][first + r];
            store(x[r], w, first + r);
        }
    }

    template <int together>
    static SHEETMORPH_INLINE void forward_below(const Front& front, int first, double* w)
    {
        const Rows<together> row(front, first);
        Lanes sums[together];
        for (int r = 0; r < together; ++r)
            sums[r] = load(w, first + r);
        take_off(row, front.columns, w, sums);
        for (int r = 0; r < together; ++r)
            store(sums[r], w, first + r);
    }

    // Takes the part of some rows, known, off the columns before `columns`.
    template <int together>
    static SHEETMORPH_INLINE void spread(const Rows<together>& row, int columns,
                                         const Lanes (&known)[together], double* w)
    {
        for (int c = 0; c < columns; ++c)
        {
            Lanes sum = load(w, c);
            for (int r = 0; r < together; ++r)
                sum -= row[r][c] * known[r];
            store(sum, w, c);
        }
    }

    template <int together>
    static SHEETMORPH_INLINE void backward_below(const Front& front, int first, double* w)
    {
        Lanes known[together];
        for (int r = 0; r < together; ++r)
            known[r] = load(w, first + r);
        spread(Rows<together>(front, first), front.columns, known, w);
    }

    template <int together>
    static SHEETMORPH_INLINE void backward_own(const Front& front, int first, double* w)
    {
        const Rows<together> row(front, first);
        Lanes x[together];
        for (int r = 0; r < together; ++r)
            x[r] = load(w, first + r);
        for (int r = together - 1; r >= 0; --r)
        {
            for (int d = r + 1; d < together; ++d)
                x[r] -= row[d][first + r] * x[d];
            x[r] /= row[r][first + r];
            store(x[r], w, first + r);
        }
        spread(row, first, x, w);
    }

    static SHEETMORPH_INLINE void forward(const Front& front, double* w)
    {
        int row = 0;
        for (; row + 4 <= front.columns; row += 4)
            forward_own<4>(front, row, w);
        for (; row < front.columns; ++row)
            forward_own<1>(front, row, w);
        const int height = front.height();
        for (; row + 8 <= height; row += 8)
            forward_below<8>(front, row, w);
        for (; row + 2 <= height; row += 2)
            forward_below<2>(front, row, w);
        if (row < height)
            forward_below<1>(front, row, w);
    }

    static SHEETMORPH_INLINE void backward(const Front& front, double* w)
    {
        const int height = front.height();
        int row = front.columns;
        for (; row + 8 <= height; row += 8)
            backward_below<8>(front, row, w);
        for (; row + 2 <= height; row += 2)
            backward_below<2>(front, row, w);
        if (row < height)
            backward_below<1>(front, row, w);
        int end = front.columns;
        for (; end % 4 != 0; --end)
            backward_own<1>(front, end - 1, w);
        for (; end > 0; end -= 4)
            backward_own<4>(front, end - 4, w);
    }
};

// The step with as many right sides as are computed side by side.
template <int width, typename Step>
SHEETMORPH_INLINE void with_sides(int sides, const Step& step)
{
    if (width == many_sides && sides == many_sides)
        step(Substitution<many_sides>());
    else
        step(Substitution<few_sides>());
}

}  // namespace

bool has_many_sides()
{
    return instructions() == Instructions::avx512;
}

void run_forward(const Front& front, int sides, double* w)
{
    const auto forward = [&](auto kernel) SHEETMORPH_INLINED { kernel.forward(front, w); };
    run_widest([&](auto width) SHEETMORPH_INLINED { with_sides<width>(sides, forward); });
}

void run_backward(const Front& front, int sides, double* w)
{
    const auto backward = [&](auto kernel) SHEETMORPH_INLINED { kernel.backward(front, w); };
    run_widest([&](auto width) SHEETMORPH_INLINED { with_sides<width>(sides, backward); });
}

}  // namespace sheetmorph

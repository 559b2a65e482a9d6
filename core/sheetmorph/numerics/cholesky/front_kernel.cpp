// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/front_kernel.h"

#include "sheetmorph/base/instructions/instructions.h"

#include <algorithm>

#define HWY_TARGET_INCLUDE "sheetmorph/numerics/cholesky/front_kernel.cpp"
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

// `together` rows of a front, from `first` on.
template <int together>
struct Rows
{
    const double* at[together];

    HWY_INLINE Rows(const Front& front, int first)
    {
        for (int r = 0; r < together; ++r)
            at[r] = front.entries.get() + static_cast<long>(first + r) * front.columns;
    }

    HWY_INLINE const double* operator[](int r) const { return at[r]; }
};

// Substitution for `sides` right-hand sides at once.
template <int sides>
struct Substitution
{
    using Part = hn::CappedTag<double, sides>;
    static constexpr int width = static_cast<int>(hn::MaxLanes(Part()));

    struct Lanes
    {
        hn::Vec<Part> part[sides / width];

        // An implicit constructor would not be compiled for the instruction set.
        HWY_INLINE Lanes() {}

        // this -= factor * other
        HWY_INLINE void take_off(double factor, const Lanes& other)
        {
            for (int p = 0; p < sides / width; ++p)
                part[p] = hn::NegMulAdd(hn::Set(Part(), factor), other.part[p], part[p]);
        }

        HWY_INLINE void divide(double divisor)
        {
            for (auto& one : part)
                one = one / hn::Set(Part(), divisor);
        }

        HWY_INLINE void add_to(double* sums) const
        {
            for (int p = 0; p < sides / width; ++p)
                hn::StoreU(hn::LoadU(Part(), sums + p * width) + part[p], Part(), sums + p * width);
        }
    };

    static HWY_INLINE Lanes load(const double* w, int row)
    {
        Lanes value;
        for (int p = 0; p < sides / width; ++p)
            value.part[p] = hn::LoadU(Part(), w + sides * row + p * width);
        return value;
    }

    static HWY_INLINE void store(const Lanes& value, double* w, int row)
    {
        for (int p = 0; p < sides / width; ++p)
            hn::StoreU(value.part[p], Part(), w + sides * row + p * width);
    }

    // Subtracts the part of the columns before `columns` from some rows.
    template <int together>
    static HWY_INLINE void take_off(const Rows<together>& row, int columns, const double* w,
                                    Lanes (&sums)[together])
    {
        for (int c = 0; c < columns; ++c)
        {
            const Lanes x = load(w, c);
            for (int r = 0; r < together; ++r)
                sums[r].take_off(row[r][c], x);
        }
    }

    template <int together>
    static HWY_INLINE void forward_own(const Front& front, int first, double* w)
    {
        const Rows<together> row(front, first);
        Lanes x[together];
        for (int r = 0; r < together; ++r)
            x[r] = load(w, first + r);
        take_off(row, first, w, x);
        for (int r = 0; r < together; ++r)
        {
            for (int d = 0; d < r; ++d)
                x[r].take_off(row[r][first + d], x[d]);
            x[r].divide(row[r][first + r]);
            store(x[r], w, first + r);
        }
    }

    // Rows of a front that are stored in its own order.
    struct InPlace
    {
        double* x;

        HWY_INLINE double* of(int row) const { return x + sides * static_cast<long>(row); }
    };

    struct InSlots
    {
        const int* rows;
        double* x;
        const int* top_row;
        double* above;

        HWY_INLINE double* of(int row) const
        {
            const int slot = rows[row];
            const int top = above != nullptr ? top_row[slot] : -1;
            return top >= 0 ? above + sides * static_cast<long>(top)
                            : x + sides * static_cast<long>(slot);
        }
    };

    template <int together, class Target>
    static HWY_INLINE void forward_below(const Front& front, int first, const double* w,
                                         const Target& target)
    {
        Lanes sums[together];
        for (Lanes& sum : sums)
            for (auto& part : sum.part)
                part = hn::Zero(Part());
        take_off(Rows<together>(front, first), front.columns, w, sums);
        for (int r = 0; r < together; ++r)
            sums[r].add_to(target.of(first + r));
    }

    // Subtracts the part of some known rows from the columns before `columns`.
    template <int together>
    static HWY_INLINE void spread(const Rows<together>& row, int columns,
                                  const Lanes (&known)[together], double* w)
    {
        for (int c = 0; c < columns; ++c)
        {
            Lanes sum = load(w, c);
            for (int r = 0; r < together; ++r)
                sum.take_off(row[r][c], known[r]);
            store(sum, w, c);
        }
    }

    template <int together>
    static HWY_INLINE void backward_below(const Front& front, int first, const double* x, double* w)
    {
        Lanes known[together];
        for (int r = 0; r < together; ++r)
            known[r] = load(x, front.rows()[static_cast<std::size_t>(first + r)]);
        spread(Rows<together>(front, first), front.columns, known, w);
    }

    template <int together>
    static HWY_INLINE void backward_own(const Front& front, int first, double* w)
    {
        const Rows<together> row(front, first);
        Lanes x[together];
        for (int r = 0; r < together; ++r)
            x[r] = load(w, first + r);
        for (int r = together - 1; r >= 0; --r)
        {
            for (int d = r + 1; d < together; ++d)
                x[r].take_off(row[d][first + r], x[d]);
            x[r].divide(row[r][first + r]);
            store(x[r], w, first + r);
        }
        spread(row, first, x, w);
    }

    // Collects the own rows of x, in the order of the front.
    static HWY_INLINE void gather(const Front& front, const double* x, double* w)
    {
        for (int row = 0; row < front.columns; ++row)
            store(load(x, front.rows()[static_cast<std::size_t>(row)]), w, row);
    }

    static HWY_INLINE void scatter(const Front& front, const double* w, double* x)
    {
        for (int row = 0; row < front.columns; ++row)
            store(load(w, row), x, front.rows()[static_cast<std::size_t>(row)]);
    }

    static HWY_INLINE void forward_own(const Front& front, double* w)
    {
        int row = 0;
        for (; row + 4 <= front.columns; row += 4)
            forward_own<4>(front, row, w);
        for (; row < front.columns; ++row)
            forward_own<1>(front, row, w);
    }

    template <class Target>
    static HWY_INLINE void forward_below(const Front& front, const double* w, const Target& target)
    {
        int row = front.columns;
        const int height = front.height();
        for (; row + 8 <= height; row += 8)
            forward_below<8>(front, row, w, target);
        for (; row + 2 <= height; row += 2)
            forward_below<2>(front, row, w, target);
        if (row < height)
            forward_below<1>(front, row, w, target);
    }

    static HWY_INLINE void forward(const Front& front, const InSlots& target, double* w)
    {
        gather(front, target.x, w);
        const double* const end = w + sides * front.columns;
        if (std::all_of(static_cast<const double*>(w), end,
                        [](double side) { return side == 0.0; }))
            return;  // sparse right-hand sides reach few fronts
        forward_own(front, w);
        scatter(front, w, target.x);
        forward_below(front, w, target);
    }

    static HWY_INLINE void backward(const Front& front, double* x, double* w)
    {
        gather(front, x, w);
        const int height = front.height();
        int row = front.columns;
        for (; row + 8 <= height; row += 8)
            backward_below<8>(front, row, x, w);
        for (; row + 2 <= height; row += 2)
            backward_below<2>(front, row, x, w);
        if (row < height)
            backward_below<1>(front, row, x, w);
        int end = front.columns;
        for (; end % 4 != 0; --end)
            backward_own<1>(front, end - 1, w);
        for (; end > 0; end -= 4)
            backward_own<4>(front, end - 4, w);
        scatter(front, w, x);
    }

    static HWY_INLINE void forward(const FrontRun& run)
    {
        for (const int node : run.nodes)
            for (std::size_t g = 0; g < run.x.size(); ++g)
            {
                const Front& front = *run.factor.fronts[static_cast<std::size_t>(node)];
                double* const above = run.above.empty() ? nullptr : run.above[g];
                forward(front, {front.rows().data(), run.x[g], run.top_row, above}, run.scratch);
            }
    }

    static HWY_INLINE void backward(const FrontRun& run)
    {
        for (auto node = run.nodes.rbegin(); node != run.nodes.rend(); ++node)
            for (double* const x : run.x)
                backward(*run.factor.fronts[static_cast<std::size_t>(*node)], x, run.scratch);
    }
};

// Narrower registers support few_sides only.
using Few = Substitution<few_sides>;
constexpr bool has_many = hn::MaxLanes(hn::CappedTag<double, many_sides>()) == many_sides;
using Many = Substitution<has_many ? many_sides : few_sides>;

bool has_many_sides_widest()
{
    return has_many;
}

void run_forward_widest(const FrontRun& run)
{
    run.sides == few_sides ? Few::forward(run) : Many::forward(run);
}

template <class Kernel>
HWY_INLINE void run_front(const Front& front, double* w)
{
    Kernel::forward_own(front, w);
    Kernel::forward_below(front, w, typename Kernel::InPlace{w});
}

void run_front_widest(const Front& front, int sides, double* w)
{
    sides == few_sides ? run_front<Few>(front, w) : run_front<Many>(front, w);
}

void run_backward_widest(const FrontRun& run)
{
    run.sides == few_sides ? Few::backward(run) : Many::backward(run);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph::numerics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheetmorph::numerics
{

HWY_EXPORT(has_many_sides_widest);
HWY_EXPORT(run_forward_widest);
HWY_EXPORT(run_front_widest);
HWY_EXPORT(run_backward_widest);

bool has_many_sides()
{
    return SHEETMORPH_WIDEST(has_many_sides_widest)();
}

void run_forward(const FrontRun& run)
{
    SHEETMORPH_WIDEST(run_forward_widest)(run);
}

void run_forward(const Front& front, int sides, double* w)
{
    SHEETMORPH_WIDEST(run_front_widest)(front, sides, w);
}

void run_backward(const FrontRun& run)
{
    SHEETMORPH_WIDEST(run_backward_widest)(run);
}

}  // namespace sheetmorph::numerics
#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Included once for each instruction set, as Highway's own headers are.
#if defined(SHEETMORPH_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEETMORPH_LANES
#undef SHEETMORPH_LANES
#else
#define SHEETMORPH_LANES
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sheetmorph
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

//! Arithmetic on one register of doubles: 1, 2, 4 or 8.
struct LaneFunctions
{
    using Doubles = hn::CappedTag<double, 8>;
    using Lanes = hn::Vec<Doubles>;
    using Mask = hn::Mask<Doubles>;
    static constexpr int width = static_cast<int>(hn::MaxLanes(Doubles()));

    struct Lanes3
    {
        Lanes x, y, z;
    };

    static HWY_INLINE Lanes filled(double number) { return hn::Set(Doubles(), number); }

    static HWY_INLINE Lanes load(const double* from) { return hn::LoadU(Doubles(), from); }

    static HWY_INLINE void store(Lanes value, double* to) { hn::StoreU(value, Doubles(), to); }

    // Entry `k` of each of `count` rows, from row `first` on, one row per lane.
    template <int count = width, int first = 0>
    static HWY_INLINE hn::Vec<hn::FixedTag<double, count>> gathered(
        const double* const (&rows)[width], int k)
    {
        const hn::FixedTag<double, count> lanes;
        if constexpr (count == 1)
            return hn::LoadU(lanes, rows[first] + k);
        else
            return Combine(lanes, gathered<count / 2, first + count / 2>(rows, k),
                           gathered<count / 2, first>(rows, k));
    }

    static HWY_INLINE bool any(Mask held) { return !hn::AllFalse(Doubles(), held); }

    // \param lanes  (width); receives 1 where the mask is set, else 0
    static HWY_INLINE void store(Mask held, double* lanes)
    {
        store(hn::IfThenElseZero(held, filled(1.0)), lanes);
    }

    static HWY_INLINE Lanes dot(const Lanes3& a, const Lanes3& b)
    {
        return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, a.x * b.x));
    }

    // terms[0] z^(n - 1) + ... + terms[n - 1]
    template <int n>
    static HWY_INLINE Lanes polynomial(Lanes z, const double (&terms)[n])
    {
        Lanes sum = filled(terms[0]);
        for (int k = 1; k < n; ++k)
            sum = hn::MulAdd(sum, z, filled(terms[k]));
        return sum;
    }

    // 1 / sqrt(value). Halving the exponent as an integer gives it to 3 % (the constant is from
    // Robertson, A Brief History of InvSqrt, 2012). A step adds the Taylor series of (1 - e)^(-1/2)
    // up to e^3 and raises the error to its fourth power. The least value, 1e-280, is chosen far
    // from the smallest normal double (2e-308).
    static HWY_INLINE Lanes inverse_root(Lanes given)
    {
        const hn::RebindToUnsigned<Doubles> bits;
        const Lanes value = hn::Max(given, filled(1e-280));
        const auto halved = hn::ShiftRight<1>(hn::BitCast(bits, value));
        Lanes root = hn::BitCast(Doubles(), hn::Set(bits, 0x5fe6eb50c7b537a9) - halved);
        for (int step = 0; step < 2; ++step)
        {
            const Lanes excess = hn::NegMulAdd(value * root, root, filled(1.0));
            root = hn::MulAdd(root * excess, polynomial(excess, {0.3125, 0.375, 0.5}), root);
        }
        return root;
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph
HWY_AFTER_NAMESPACE();

#endif

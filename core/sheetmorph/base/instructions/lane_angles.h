// SPDX-License-Identifier: LGPL-2.1-or-later
// Included once for each instruction set, as Highway's own headers are.
#if defined(SHEETMORPH_LANE_ANGLES) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEETMORPH_LANE_ANGLES
#undef SHEETMORPH_LANE_ANGLES
#else
#define SHEETMORPH_LANE_ANGLES
#endif

#include "sheetmorph/base/instructions/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace sheetmorph
{
namespace HWY_NAMESPACE
{

//! Angles between unit vectors, `width` at once.
struct LaneAngles : LaneFunctions
{
    // Half of atan2(sine, cosine), sine >= 0, for sine^2 + cosine^2 = 1.
    static HWY_INLINE Lanes half_angle(Lanes sine, Lanes cosine)
    {
        // From geometry: pi / 4, and the tangent of pi / 8, sqrt(2) - 1.
        constexpr double quarter_pi = 0.78539816339744830962,
                         tan_eighth_pi = 0.41421356237309504880;
        const Lanes below = filled(1.0) + hn::Abs(cosine);
        const Mask steep = sine > filled(tan_eighth_pi) * below;
        const Lanes x =
            hn::IfThenElse(steep, sine - below, sine) / hn::IfThenElse(steep, sine + below, below);
        const Lanes z = x * x;
        // (atan(x) - x) / x^3, |x| <= tan(pi / 8); error 7e-18.
        const Lanes tail =
            polynomial(z, {-0.019162068915902573, 0.03921955253255129, -0.05085030492810941,
                           0.058580687568615106, -0.06664502215671447, 0.07692182535116648,
                           -0.09090904549884611, 0.11111111014561013, -0.14285714284657894,
                           0.1999999999999548, -0.3333333333333333});
        const Lanes angle =
            hn::IfThenElseZero(steep, filled(quarter_pi)) + hn::MulAdd(x * z, tail, x);
        return hn::IfThenElse(cosine < filled(0.0), filled(2.0 * quarter_pi) - angle, angle);
    }

    // theta / (2 sin theta) as a function of t = sin^2(theta / 2), for t up to 1/4 (60 degrees).
    // Needs no root and no division. Error 3e-17.
    static HWY_INLINE Lanes narrow_half_angle_ratio(Lanes t)
    {
        const Lanes t2 = t * t, t4 = t2 * t2, t8 = t4 * t4;
        const Lanes low =
            hn::MulAdd(polynomial(t, {0.20317455738184261718, 0.2285714294359816691}), t2,
                       polynomial(t, {0.2666666666581750391, 0.33333333333336609553}));
        const Lanes middle =
            hn::MulAdd(polynomial(t, {0.14590029037055137517, 0.15953614381119621467}), t2,
                       polynomial(t, {0.17046664662467593918, 0.18470563246569015182}));
        const Lanes high =
            hn::MulAdd(polynomial(t, {-0.55664306358921529961, 0.48882777900113656649}), t2,
                       polynomial(t, {0.017569577684262441039, 0.16755628087674549646}));
        const Lanes highest = hn::MulAdd(filled(0.7768896471546718404), t4, high);
        // One rounding at the end, because cancellation would enlarge it for distant points.
        return hn::MulAdd(t, hn::MulAdd(highest, t8, hn::MulAdd(middle, t4, low)), filled(0.5));
    }

    // The same ratio for any angle, from its sine and cosine.
    static HWY_INLINE Lanes wide_half_angle_ratio(Lanes squared_sine, Lanes cosine)
    {
        const Lanes inverse_sine = inverse_root(squared_sine);
        return half_angle(squared_sine * inverse_sine, cosine) * inverse_sine;
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace sheetmorph
HWY_AFTER_NAMESPACE();

#endif

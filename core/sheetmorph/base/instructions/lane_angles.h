// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/instructions/lane_functions.h"

namespace sheetmorph
{

//! Angles between unit vectors, `width` at once.
template <int width>
struct LaneAngles : LaneFunctions<width>
{
    using Lanes = typename VectorTypes<width>::Lanes;
    using LaneFunctions<width>::filled;
    using LaneFunctions<width>::inverse_root;
    using LaneFunctions<width>::reciprocal;

    static constexpr double quarter_pi = 0.78539816339744830962;
    static constexpr double tan_eighth_pi = 0.41421356237309504880;

    // (atan(x) - x) / x^3 in z = x^2, |x| <= tan(pi / 8); error 7e-18.
    static SHEETMORPH_INLINE Lanes arc_tangent_tail(const Lanes& z)
    {
        Lanes p = z * -0.019162068915902573 + 0.03921955253255129;
        p = p * z - 0.05085030492810941;
        p = p * z + 0.058580687568615106;
        p = p * z - 0.06664502215671447;
        p = p * z + 0.07692182535116648;
        p = p * z - 0.09090904549884611;
        p = p * z + 0.11111111014561013;
        p = p * z - 0.14285714284657894;
        p = p * z + 0.1999999999999548;
        return p * z - 0.3333333333333333;
    }

    // Half of atan2(sine, cosine), sine >= 0, for sine^2 + cosine^2 = 1.
    static SHEETMORPH_INLINE Lanes half_angle(const Lanes& sine, const Lanes& cosine)
    {
        const Lanes zero = {};
        const Lanes below = 1.0 + (cosine < 0.0 ? -cosine : cosine);
        const auto steep = sine > tan_eighth_pi * below;
        const Lanes x = (steep ? sine - below : sine) * reciprocal(steep ? sine + below : below);
        const Lanes z = x * x;
        const Lanes angle = (steep ? filled(quarter_pi) : zero) + (x + x * z * arc_tangent_tail(z));
        return cosine < 0.0 ? 2.0 * quarter_pi - angle : angle;
    }

    // theta / (2 sin theta) in t = sin^2(theta / 2) up to 1/4, so 60 degrees: no root, no division.
    // Error 3e-17.
    static SHEETMORPH_INLINE Lanes narrow_half_angle_ratio(const Lanes& t)
    {
        const Lanes t2 = t * t, t4 = t2 * t2, t8 = t4 * t4;
        const Lanes low = (0.33333333333336609553 + 0.2666666666581750391 * t)
                          + (0.2285714294359816691 + 0.20317455738184261718 * t) * t2;
        const Lanes middle = (0.18470563246569015182 + 0.17046664662467593918 * t)
                             + (0.15953614381119621467 + 0.14590029037055137517 * t) * t2;
        const Lanes high = (0.16755628087674549646 + 0.017569577684262441039 * t)
                           + (0.48882777900113656649 - 0.55664306358921529961 * t) * t2;
        // One rounding at the end: far points lose what this loses to cancellation.
        return 0.5 + t * ((low + middle * t4) + (high + 0.7768896471546718404 * t4) * t8);
    }

    // Any angle: half of it over the sine, from both of its functions.
    static SHEETMORPH_INLINE Lanes wide_half_angle_ratio(const Lanes& squared_sine,
                                                         const Lanes& cosine)
    {
        const Lanes inverse_sine = inverse_root(squared_sine);
        return half_angle(squared_sine * inverse_sine, cosine) * inverse_sine;
    }
};

}  // namespace sheetmorph

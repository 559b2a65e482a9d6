// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/instructions/vector_types.h"

#include <cstring>

// Everything that returns Lanes is inlined: nothing depends on the calling convention of vectors.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace sheetmorph
{

//! Arithmetic on `width` doubles at once, all of it inlined.
template <int width>
struct LaneFunctions
{
    using Lanes = typename VectorTypes<width>::Lanes;
    using Bits = typename VectorTypes<width>::Bits;

    static SHEETMORPH_INLINE Lanes filled(double number)
    {
        const Lanes zero = {};
        return zero + number;
    }

    // A guess of 1 / sqrt(value) to 14 bits where the processor has one, else to 3: the exponent
    // halved as an integer. The library's square root sets errno, so it would be scalar.
    static SHEETMORPH_INLINE Lanes guessed_inverse_root(const Lanes& value)
    {
        Lanes root;
        if constexpr (width == 8)
        {
            asm("vrsqrt14pd %1, %0" : "=v"(root) : "v"(value));
            return root;
        }
        Bits bits;
        std::memcpy(&bits, &value, sizeof bits);
        bits = 0x5fe6eb50c7b537a9LL - (bits >> 1);
        std::memcpy(&root, &bits, sizeof root);
        // Cubic convergence.
        const Lanes excess = 1.0 - value * root * root;
        return root + root * excess * (0.5 + 0.375 * excess);
    }

    // 1 / sqrt(value), value >= 1e-280.
    static SHEETMORPH_INLINE Lanes inverse_root(const Lanes& given)
    {
        const Lanes value = given > 1e-280 ? given : filled(1e-280);
        Lanes root = guessed_inverse_root(value);
        if constexpr (width == 8)
        {
            // From 14 bits by one step of fourth order.
            const Lanes excess = 1.0 - value * root * root;
            return root + root * excess * (0.5 + excess * (0.375 + 0.3125 * excess));
        }
        for (int step = 0; step < 2; ++step)
        {
            const Lanes excess = 1.0 - value * root * root;
            root = root + root * excess * (0.5 + 0.375 * excess);
        }
        return root;
    }

    // 1 / value, for values whose reciprocal is neither huge nor tiny.
    static SHEETMORPH_INLINE Lanes reciprocal(const Lanes& value)
    {
        if constexpr (width == 8)
        {
            Lanes guess;
            asm("vrcp14pd %1, %0" : "=v"(guess) : "v"(value));
            guess = guess + guess * (1.0 - value * guess);
            return guess + guess * (1.0 - value * guess);
        }
        else
            return 1.0 / value;
    }

    // Whether any lane of a comparison holds.
    static SHEETMORPH_INLINE bool any(const Bits& held)
    {
        int mask;
        if constexpr (width == 8)
            asm("vpmovq2m %1, %%k1\n\tkmovb %%k1, %0" : "=r"(mask) : "v"(held) : "k1");
        else if constexpr (width == 4)
            asm("vmovmskpd %1, %0" : "=r"(mask) : "x"(held));
        else
            asm("movmskpd %1, %0" : "=r"(mask) : "x"(held));
        return mask != 0;
    }
};

}  // namespace sheetmorph

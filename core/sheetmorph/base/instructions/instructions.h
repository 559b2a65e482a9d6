// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Kernels are compiled for the baseline of the compiler (any x86-64, NEON), for SSSE3, AVX2 and
// AVX-512 (AVX3). Other sets gain nothing; registers of no fixed size (SVE, RVV) do not fit the
// layouts of the kernels.
#define HWY_DISABLED_TARGETS \
    ((HWY_AVX3 - 1) | HWY_SSE4 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/targets.h>

//! The function that HWY_EXPORT named, compiled for the widest instructions of this processor that
//! limit_instructions() allows.
#define SHEETMORPH_WIDEST(function) \
    (::sheetmorph::limit_instructions(), HWY_DYNAMIC_DISPATCH(function))

namespace sheetmorph
{

//! Applies the environment variable SHEETMORPH_INSTRUCTIONS, once: ssse3 and avx2 exclude wider
//! instructions, portable all that not every processor has.
void limit_instructions();

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Kernels are compiled for the baseline of the compiler (any x86-64, NEON) and for SSSE3, AVX2 and
// AVX-512 (AVX3). Other sets bring no gain. Registers of variable size (SVE, RVV) do not fit the
// layouts of the kernels.
#define HWY_DISABLED_TARGETS \
    ((HWY_AVX3 - 1) | HWY_SSE4 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/targets.h>

//! The function that HWY_EXPORT named, for the widest instructions that both the processor and
//! limit_instructions() allow.
#define SHEETMORPH_WIDEST(function) \
    (::sheetmorph::limit_instructions(), HWY_DYNAMIC_DISPATCH(function))

namespace sheetmorph
{

//! Applies the environment variable SHEETMORPH_INSTRUCTIONS once. The values ssse3 and avx2 exclude
//! wider instructions; portable excludes everything beyond the baseline.
void limit_instructions();

}  // namespace sheetmorph

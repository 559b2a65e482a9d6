// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/instructions/instructions.h"
#include "sheetmorph/base/instructions/vector_types.h"

#include <type_traits>

namespace sheetmorph
{

// Fused multiply-adds where the processor has them, as in the files of the kernels: what is inlined
// here is compiled as these functions are.
#pragma GCC push_options
#pragma GCC optimize("fp-contract=fast")

template <typename Step>
__attribute__((target("avx512f,avx512vl,avx512dq,fma,prefer-vector-width=512"))) void run_avx512(
    const Step& step)
{
    step(std::integral_constant<int, 8>());
}

template <typename Step>
__attribute__((target("avx2,fma"))) void run_avx2(const Step& step)
{
    step(std::integral_constant<int, 4>());
}

//! Runs a step that is compiled for the widest instructions of this processor.
//! \param step  `[&](auto width) SHEETMORPH_INLINED { ... }`, all that computes in it inlined;
//!              width: how many doubles a register holds, a constant: 8, 4 or 2
template <typename Step>
void run_widest(const Step& step)
{
    if (instructions() == Instructions::avx512)
        run_avx512(step);
    else if (instructions() == Instructions::avx2)
        run_avx2(step);
    else
        step(std::integral_constant<int, 2>());
}

#pragma GCC pop_options

}  // namespace sheetmorph

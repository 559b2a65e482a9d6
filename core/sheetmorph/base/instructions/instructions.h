// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph
{

//! Instruction sets that kernels are compiled for beside the portable one.
enum class Instructions
{
    portable,  //!< any x86-64
    avx2,      //!< with fused multiply-adds: x86-64-v3
    avx512     //!< x86-64-v4
};

//! The widest that the processor has, or no more than the environment variable
//! SHEETMORPH_INSTRUCTIONS (portable, avx2, avx512) allows. Found once.
Instructions instructions();

}  // namespace sheetmorph

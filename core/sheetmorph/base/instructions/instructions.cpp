// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/instructions/instructions.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace sheetmorph
{

namespace
{

Instructions of_processor()
{
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        return Instructions::portable;
    return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")
               ? Instructions::avx512
               : Instructions::avx2;
}

Instructions allowed()
{
    const char* const told = std::getenv("SHEETMORPH_INSTRUCTIONS");
    const std::string name = told != nullptr ? told : "";
    if (name == "portable")
        return Instructions::portable;
    return name == "avx2" ? Instructions::avx2 : Instructions::avx512;
}

}  // namespace

Instructions instructions()
{
    static const Instructions widest = std::min(of_processor(), allowed());
    return widest;
}

}  // namespace sheetmorph

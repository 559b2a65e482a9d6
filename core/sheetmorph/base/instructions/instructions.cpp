// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/instructions/instructions.h"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace sheetmorph
{

namespace
{

// Within a processor family, the wider set has the lower bit.
[[maybe_unused]] std::int64_t excluded()
{
    const char* const given = std::getenv("SHEETMORPH_INSTRUCTIONS");
    const std::string name = given != nullptr ? given : "";
    if (name == "portable")
        return HWY_STATIC_TARGET - 1;
    if (name == "ssse3")
        return HWY_SSSE3 - 1;
    return name == "avx2" ? HWY_AVX2 - 1 : 0;
}

}  // namespace

void limit_instructions()
{
#if (HWY_TARGETS & (HWY_TARGETS - 1)) != 0  // more than one target
    [[maybe_unused]] static const bool is_limited = []
    {
        // Other users of Highway in this process keep their limits.
        if (excluded() != 0)
            hwy::DisableTargets(excluded());
        return true;
    }();
#endif
}

}  // namespace sheetmorph

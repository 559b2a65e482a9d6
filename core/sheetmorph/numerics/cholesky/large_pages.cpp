// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/large_pages.h"

#include <cstdint>
#include <sys/mman.h>

namespace sheetmorph
{

void prefer_large_pages(double* begin, std::size_t count)
{
    constexpr std::uintptr_t page = 2097152;
    constexpr std::size_t fewest = 2 * page;  // bytes
    if (count * sizeof(double) < fewest)
        return;
    const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
    const auto end = reinterpret_cast<std::uintptr_t>(begin + count) / page * page;
    // Only advice: a system without such pages refuses it, and nothing is lost.
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace sheetmorph

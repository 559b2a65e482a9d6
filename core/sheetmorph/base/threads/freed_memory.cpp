// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/threads/freed_memory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sheetmorph
{

void return_freed_memory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace sheetmorph

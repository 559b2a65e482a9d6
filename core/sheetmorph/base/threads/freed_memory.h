// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph
{

//! Returns freed memory to the system. After a set-up on several threads, glibc would otherwise
//! keep hundreds of MB. Does nothing with other C libraries.
void return_freed_memory();

}  // namespace sheetmorph

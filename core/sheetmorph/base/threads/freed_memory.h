// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace sheetmorph
{

//! Returns freed memory to the system. glibc keeps it otherwise, hundreds of MB after a set-up on
//! several threads. Does nothing with other C libraries.
void return_freed_memory();

}  // namespace sheetmorph

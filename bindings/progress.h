// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/progress.h"

#include <pybind11/pybind11.h>

namespace sheetmorph
{

//! A Python callable (fraction, task) -> anything; returning False cancels; None: no progress. The
//! work is done without the GIL, so it is taken for each report, and only in the thread that made
//! it: Python that runs in another one may collect garbage there, widgets among it, which belong to
//! the window's. The callable must outlive it.
Progress progress_from(const pybind11::object& callback);

}  // namespace sheetmorph

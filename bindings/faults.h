// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/errors.h"

#include <pybind11/pybind11.h>

#include <exception>

namespace sheetmorph
{

//! Makes an error of the kernel the exception of that name in sheetmorph._core, for every module.
//! InvalidInput and SolverError are SheetMorphErrors of the package, with one Fault. Its objects
//! are those at fault, or the part; its vertices have the numbers of the part's file.
void translate_errors(std::exception_ptr thrown);

}  // namespace sheetmorph

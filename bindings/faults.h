// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/errors.h"

#include <pybind11/pybind11.h>

#include <exception>

namespace sheetmorph
{

//! Makes an error of the kernel the exception of that name in sheetmorph._core, for every module.
//! InvalidInput and SolverError have their fault as attributes. what, brief (without numbers of
//! vertices), todo, code; where: the part that stands in front; objects: pairs of kind and name,
//! those at fault, of a part alone that part; vertices: the listed ones, as the part's file numbers
//! them.
void translate_errors(std::exception_ptr thrown);

}  // namespace sheetmorph

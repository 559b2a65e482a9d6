// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/errors.h"

#include <pybind11/pybind11.h>

namespace sheetmorph
{

//! Sets the Python error: an exception whose attributes tell the fault, so that nobody has to read
//! its text. what, brief (without numbers of vertices), todo, code; where: the part that stands in
//! front; objects: pairs of kind and name, those at fault, of a part alone that part; vertices: the
//! listed ones, as the part's file numbers them.
void set_error(const pybind11::handle& type, const Fault& fault);

}  // namespace sheetmorph

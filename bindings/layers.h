// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace sheetmorph
{

//! One function a layer adds its names to sheetmorph._core.
void bind_base(pybind11::module_& module);
void bind_triangle_mesh(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_pick(pybind11::module_& module);
void bind_features(pybind11::module_& module);
void bind_diagnosis(pybind11::module_& module);
void bind_thin(pybind11::module_& module);
void bind_repair(pybind11::module_& module);
void bind_recognise(pybind11::module_& module);
void bind_description(pybind11::module_& module);
void bind_session(pybind11::module_& module);
void bind_flat(pybind11::module_& module);

}  // namespace sheetmorph

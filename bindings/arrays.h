// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>

namespace sheetmorph
{

//! numpy to kernel: strict about type and shape, so that nothing is converted or copied twice
//! behind the caller's back, and strict about numbers: finite, none beyond 1e30.
//! \throws pybind11::type_error, pybind11::value_error, InvalidInput naming `what`

//! (n, 3) float64, C order.
Points points_from(const pybind11::handle& array, const std::string& what);

//! (m, 3) int32 or int64.
Triangles triangles_from(const pybind11::handle& array, const std::string& what);

//! (k) int32 or int64, or a list of Python integers.
VertexIds ids_from(const pybind11::handle& array, const std::string& what);

//! (3) numbers, a list or an array.
Vector3 vector_from(const pybind11::handle& array, const std::string& what);

//! Kernel to numpy; the array takes the memory over.
pybind11::array_t<double> to_numpy(Points&& points);
pybind11::array_t<int> to_numpy(Triangles&& triangles);
pybind11::array_t<int> to_numpy(const VertexIds& ids);
pybind11::list to_lists(const std::vector<VertexIds>& ids);
pybind11::array_t<double> to_numpy(const Vector3& vector);
pybind11::array_t<double> to_numpy(const Matrix3& matrix);

//! (n, 3) float64 that looks into `points` and keeps `owner` alive; read-only.
pybind11::array_t<double> view_of(const Points& points, const pybind11::handle& owner);

}  // namespace sheetmorph

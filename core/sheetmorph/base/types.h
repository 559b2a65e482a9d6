// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sheetmorph
{

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

//! (n, 3) positions in mm, one row per vertex; the memory layout of a C-order numpy array.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

//! (m, 3) vertex indices, one row per triangle, counted from 0.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

//! Vertex indices counted from 0.
using VertexIds = std::vector<int>;

}  // namespace sheetmorph

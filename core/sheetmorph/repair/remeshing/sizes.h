// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/patches.h"

namespace sheetmorph::repair
{

//! Largest growth of the edge length per distance. Chosen: neighbouring edges differ by a third at
//! most, and triangles between them stay well-shaped.
constexpr double size_growth = 0.3;

//! Upper limits of the edge length.
struct SizeLimits
{
    double edge = 1.0;                //!< everywhere, mm
    std::vector<double> at_vertices;  //!< (n) at every vertex, mm
};

//! The target edge length at every vertex (n), mm. It is largest on flats and shorter near ridges
//! with short segments (rims of holes) and near curved regions. From there it grows slowly.
std::vector<double> wanted_sizes(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                                 const Patches& patches, const SizeLimits& limits);

}  // namespace sheetmorph::repair

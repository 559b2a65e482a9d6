// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/patches.h"

namespace sheetmorph::repair
{

//! How fast edges may grow with the distance from something small.
constexpr double size_growth = 0.3;

//! The longest edges wanted.
struct SizeLimits
{
    double edge = 1.0;                //!< anywhere, mm
    std::vector<double> at_vertices;  //!< (n) at every vertex, mm
};

//! The edge length wanted at every vertex (n), mm: the longest on flats, shorter where ridges have
//! short segments (rims of holes) and where the sheet is curved, growing slowly from there.
std::vector<double> wanted_sizes(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                                 const Patches& patches, const SizeLimits& limits);

}  // namespace sheetmorph::repair

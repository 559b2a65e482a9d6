// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/sizes.h"

#include <utility>

namespace sheetmorph
{

//! A vertex put into an edge of the mesh: at from + share * (to - from).
struct EdgePlace
{
    int from = -1, to = -1;
    double share = 0.0;
};

//! A mesh whose ridges are cut into short segments.
struct CutMesh
{
    TriangleMesh mesh;                        //!< the vertices given, then those of `places`
    std::vector<EdgePlace> places;            //!< where the new vertices stand, in order
    std::vector<double> sizes;                //!< (n) the edge length wanted at every vertex, mm
    std::vector<int> triangle_of;             //!< (m) the triangle given that each is part of
    std::vector<std::pair<int, int>> ridges;  //!< (smaller, larger) vertex of every segment, sorted
};

//! Cuts every ridge into segments as long as wanted, the same way for all the triangles at it.
CutMesh cut_ridges(const TriangleMesh& mesh, const EdgeTable& table, const Patches& patches,
                   const SizeLimits& limits);

}  // namespace sheetmorph

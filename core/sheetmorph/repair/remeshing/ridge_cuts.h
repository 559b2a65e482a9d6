// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/sizes.h"

#include <utility>

namespace sheetmorph::repair
{

//! A vertex inserted into an edge of the mesh, at from + share * (to - from).
struct EdgePlace
{
    int from = -1, to = -1;
    double share = 0.0;
};

//! A mesh whose ridges are cut into short segments.
struct CutMesh
{
    mesh::TriangleMesh mesh;        //!< the input vertices, then those of `places`
    std::vector<EdgePlace> places;  //!< positions of the new vertices, in order
    std::vector<double> sizes;      //!< (n) target edge length at every vertex, mm
    std::vector<int> triangle_of;   //!< (m) the input triangle that each triangle is part of
    std::vector<std::pair<int, int>> ridges;  //!< (smaller, larger) vertex of every segment, sorted
};

//! A point at which an edge must be cut, because its twin edge has a vertex there.
struct TwinStop
{
    int from = -1, to = -1;  //!< the smaller and the larger vertex of the edge
    double share = 0.0;      //!< position from + share * (to - from)
    int vertex = -1;         //!< the vertex of the twin outline
};

struct CutWish
{
    SizeLimits sizes;
    std::vector<TwinStop> stops;
};

//! Cuts every ridge into segments of the target length, identically for all its triangles.
//! \param wanted  target sizes, see wanted_sizes(), and prescribed cuts
CutMesh cut_ridges(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                   const Patches& patches, const CutWish& wanted);

}  // namespace sheetmorph::repair

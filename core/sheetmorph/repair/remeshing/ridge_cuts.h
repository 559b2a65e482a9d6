// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/sizes.h"

#include <utility>

namespace sheetmorph::repair
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
    mesh::TriangleMesh mesh;                  //!< the vertices given, then those of `places`
    std::vector<EdgePlace> places;            //!< where the new vertices stand, in order
    std::vector<double> sizes;                //!< (n) the edge length wanted at every vertex, mm
    std::vector<int> triangle_of;             //!< (m) the triangle given that each is part of
    std::vector<std::pair<int, int>> ridges;  //!< (smaller, larger) vertex of every segment, sorted
};

//! Where an edge must be cut, because another one is that is meshed alike.
struct TwinStop
{
    int from = -1, to = -1;  //!< the smaller and the larger vertex of the edge
    double share = 0.0;      //!< at from + share * (to - from)
    int vertex = -1;         //!< the vertex of the other that it stands for
};

struct CutWish
{
    SizeLimits sizes;
    std::vector<TwinStop> stops;
};

//! Cuts every ridge into segments as long as wanted, the same way for all the triangles at it.
//! \param wanted  the sizes at every vertex, see wanted_sizes(), and anywhere; places to stop at
CutMesh cut_ridges(const mesh::TriangleMesh& mesh, const mesh::EdgeTable& table,
                   const Patches& patches, const CutWish& wanted);

}  // namespace sheetmorph::repair

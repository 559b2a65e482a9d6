// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/ridge_cuts.h"

#include <map>

namespace sheetmorph::repair
{

//! Two flats with the same outline that face away from each other, like the skins of a plate. They
//! get the same mesh, so that both skins of a thin solid bend along the same chords.
struct TwinFlats
{
    int flat = -1, twin = -1;      //!< patches
    Vector3 way;                   //!< offset from flat to twin along their normal, mm
    std::map<int, int> vertex_of;  //!< by vertex of the flat's outline: its twin vertex
};

struct PatchedMesh
{
    const mesh::TriangleMesh& mesh;
    const std::vector<int>& patch;                   //!< (m)
    const std::vector<std::pair<int, int>>& ridges;  //!< (smaller, larger) vertex, sorted
};

//! Twins, and the vertices of one outline that the other outline needs as well.
struct FoundTwins
{
    std::vector<TwinFlats> twins;
    std::vector<TwinStop> stops;
};

//! Finds twins among the flats larger than `least_area`. Each patch is in at most one pair.
//! \param is_flat     by patch
//! \param least_area  mm^2
FoundTwins find_twin_flats(const PatchedMesh& given, const std::vector<char>& is_flat,
                           double least_area);

//! The same pairs in a mesh with cut ridges, without pairs whose ridges were cut differently.
std::vector<TwinFlats> twins_after_cuts(const std::vector<TwinFlats>& twins,
                                        const PatchedMesh& cut);

//! Sizes (n) that agree on both outlines of every pair: the smaller size of each.
std::vector<double> evened(std::vector<double> sizes, const std::vector<TwinFlats>& twins);

}  // namespace sheetmorph::repair

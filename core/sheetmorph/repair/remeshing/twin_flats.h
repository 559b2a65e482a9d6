// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/ridge_cuts.h"

#include <map>

namespace sheetmorph::repair
{

//! Two flats with the same outline that face away from each other, as the skins of a plate do. They
//! are meshed alike, so that a thin solid bends with the same chords on either side.
struct TwinFlats
{
    int flat = -1, twin = -1;      //!< patches
    Vector3 way;                   //!< from the one to the other, along their normal, mm
    std::map<int, int> vertex_of;  //!< of the outline of the flat: the vertex in its place
};

//! A mesh and its patches.
struct PatchedMesh
{
    const mesh::TriangleMesh& mesh;
    const std::vector<int>& patch;                   //!< (m)
    const std::vector<std::pair<int, int>>& ridges;  //!< (smaller, larger) vertex, sorted
};

//! Twins, and where one outline has a vertex that the other one needs too.
struct FoundTwins
{
    std::vector<TwinFlats> twins;
    std::vector<TwinStop> stops;
};

//! The twins among the flats of more than some area; each patch is in one pair at most.
//! \param is_flat     of every patch
//! \param least_area  mm^2
FoundTwins find_twin_flats(const PatchedMesh& given, const std::vector<char>& is_flat,
                           double least_area);

//! The same pairs in a mesh whose ridges were cut; without those that were cut differently.
std::vector<TwinFlats> twins_after_cuts(const std::vector<TwinFlats>& twins,
                                        const PatchedMesh& cut);

//! Sizes (n) that are the same on both outlines of every pair: the smaller ones.
std::vector<double> evened(std::vector<double> sizes, const std::vector<TwinFlats>& twins);

}  // namespace sheetmorph::repair

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/patch_trees.h"
#include "sheetmorph/repair/remeshing/remeshing.h"
#include "sheetmorph/repair/remeshing/ridge_cuts.h"
#include "sheetmorph/repair/remeshing/twin_flats.h"
#include "sheetmorph/repair/remeshing/working_mesh.h"

namespace sheetmorph::repair
{

//! The input that a remeshed mesh is compared with.
struct RemeshSource
{
    const mesh::TriangleMesh& mesh;
    const mesh::EdgeTable& table;
    const Patches& patches;
    const CutMesh& cut;
    const PatchTrees& trees;
    const std::vector<TwinFlats>& twins;  //!< the working mesh does not contain the twins
    int circles;
};

//! Builds the final mesh. Input vertices that are still in place come first, in their order, then
//! the new ones.
RemeshedMesh result_of(const WorkingMesh& work, const RemeshSource& source);

}  // namespace sheetmorph::repair

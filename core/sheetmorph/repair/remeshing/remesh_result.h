// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/repair/remeshing/patch_trees.h"
#include "sheetmorph/repair/remeshing/remeshing.h"
#include "sheetmorph/repair/remeshing/ridge_cuts.h"
#include "sheetmorph/repair/remeshing/twin_flats.h"
#include "sheetmorph/repair/remeshing/working_mesh.h"

namespace sheetmorph::repair
{

//! What a remeshed mesh is compared with.
struct RemeshSource
{
    const mesh::TriangleMesh& mesh;  //!< as it was given
    const mesh::EdgeTable& table;
    const Patches& patches;
    const CutMesh& cut;
    const PatchTrees& trees;
    const std::vector<TwinFlats>& twins;  //!< the twins are not in the working mesh
    int circles;
};

//! The finished mesh: the vertices given that are still in place first, in their order, then the
//! new ones.
RemeshedMesh result_of(const WorkingMesh& work, const RemeshSource& source);

}  // namespace sheetmorph::repair

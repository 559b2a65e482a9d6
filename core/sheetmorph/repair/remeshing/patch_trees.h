// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"

namespace sheetmorph::repair
{

//! Answers what is nearest on one patch of a mesh, however near the others are.
class PatchTrees
{
public:
    //! \param patch  (m) of every triangle
    PatchTrees(const mesh::TriangleMesh& mesh, const std::vector<int>& patch);

    //! The place on a patch nearest to a point; its triangle is one of the whole mesh.
    mesh::Hit nearest(int patch, const Vector3& point) const;

private:
    std::vector<std::vector<int>> triangles_;
    std::vector<mesh::PickingTree> trees_;
};

}  // namespace sheetmorph::repair

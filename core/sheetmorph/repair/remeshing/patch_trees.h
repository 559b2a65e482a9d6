// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"

namespace sheetmorph::repair
{

//! Nearest-point queries restricted to one patch of a mesh, however near other patches are.
class PatchTrees
{
public:
    //! \param patch  (m) patch of every triangle
    PatchTrees(const mesh::TriangleMesh& mesh, const std::vector<int>& patch);

    //! The point of a patch nearest to `point`; its triangle refers to the whole mesh.
    mesh::Hit nearest(int patch, const Vector3& point) const;

private:
    std::vector<std::vector<int>> triangles_;
    std::vector<mesh::PickingTree> trees_;
};

}  // namespace sheetmorph::repair

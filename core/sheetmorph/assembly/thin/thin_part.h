// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/links/patch_anchors.h"
#include "sheetmorph/mesh/topology/submesh.h"
#include "sheetmorph/recognise/thin/across_sheet.h"

namespace sheetmorph::assembly
{

//! The image of a region of a thin solid on its main skin; indices into the skin, ascending.
struct SkinRegion
{
    VertexIds own;    //!< vertices of the region that lie on the skin
    VertexIds below;  //!< skin vertices under the rest of it
};

//! A thin solid for the solvers: its main skin, moved to the middle of the sheet. So it bends as
//! the open mid-surface would, whichever skin is the main one. Also the way all other vertices
//! follow it. The constructor finds the place of every vertex on the skin across the sheet.
class ThinPart
{
public:
    ThinPart(mesh::TriangleMesh mesh, recognise::ThinSolid solid);

    const mesh::TriangleMesh& mesh() const { return mesh_; }
    const recognise::ThinSolid& solid() const { return solid_; }
    const mesh::Submesh& skin() const { return skin_; }

    //! The mesh that is solved: the triangles of the main skin, in the middle of the sheet.
    const mesh::TriangleMesh& middle() const { return middle_; }

    //! The places of a vertex of the whole part on the main skin, in vertices of the skin: the
    //! nearest across its own sheet, and all equally near ones. Empty for a vertex without a
    //! triangle, which stays at rest.
    using Anchors = std::vector<mesh::Anchor>;
    const Anchors& anchors(int vertex) const { return anchors_[static_cast<std::size_t>(vertex)]; }

    //! Skin vertices lie under a region if their opposite points are on its triangles. A vertex
    //! that covers none lies over the nearest skin vertex, so that no region is lost.
    SkinRegion on_skin(const VertexIds& region) const;

    //! The feature with its walls. If a feature contains the whole rim of a hole on one skin, the
    //! wall and the other rim are added.
    VertexIds with_walls(const VertexIds& feature) const;

private:
    void hang_on_skin(const recognise::AcrossSheet& across);
    void find_feet(const recognise::AcrossSheet& across);
    void find_middle();
    void add_below(const VertexIds& region, const std::vector<char>& is_covered,
                   SkinRegion& found) const;

    mesh::TriangleMesh mesh_;
    recognise::ThinSolid solid_;
    mesh::Submesh skin_;
    mesh::TriangleMesh middle_;
    std::vector<Anchors> anchors_;
    std::vector<Anchors> feet_;     // by skin vertex: its opposite places
    std::vector<VertexIds> above_;  // by vertex: skin vertices with feet on its triangles
    std::vector<VertexIds> rims_;   // of the walls: vertices on the main, then on the
    std::vector<int> wall_of_rim_;  // opposite skin
};

}  // namespace sheetmorph::assembly

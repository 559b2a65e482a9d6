// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/links/patch_anchors.h"
#include "sheetmorph/mesh/topology/submesh.h"
#include "sheetmorph/recognise/thin/across_sheet.h"

namespace sheetmorph::assembly
{

//! What a region of a thin solid is on its main skin; indices into the skin, ascending.
struct SkinRegion
{
    VertexIds own;    //!< vertices of the region that lie on the skin
    VertexIds below;  //!< skin vertices under the rest of it
};

//! A thin solid as the solvers see it: its main skin alone, pushed to the middle of the sheet, so
//! that it bends as the open mid-surface would whichever skin is the main one; and how everything
//! hangs on it. The constructor finds for every vertex its place on the skin across the sheet.
class ThinPart
{
public:
    ThinPart(mesh::TriangleMesh mesh, recognise::ThinSolid solid);

    const mesh::TriangleMesh& mesh() const { return mesh_; }
    const recognise::ThinSolid& solid() const { return solid_; }
    const mesh::Submesh& skin() const { return skin_; }

    //! The mesh that is solved: the main skin's triangles in the middle of the sheet.
    const mesh::TriangleMesh& middle() const { return middle_; }

    //! Places of a vertex of the whole part on the main skin, in the skin's own vertices: the
    //! nearest across its own sheet, and as many as are equally near. None for a vertex of no
    //! triangle, which stays where it is.
    using Anchors = std::vector<mesh::Anchor>;
    const Anchors& anchors(int vertex) const { return anchors_[static_cast<std::size_t>(vertex)]; }

    //! Skin vertices are under a region if what is opposite them lies on its triangles; a vertex
    //! that covers none is over the nearest skin vertex, so that no region is lost.
    SkinRegion on_skin(const VertexIds& region) const;

    //! A feature with the walls it goes along: who has the whole rim of a hole on one skin has the
    //! wall and the other rim too.
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
    std::vector<Anchors> feet_;     // by skin vertex: the opposite places, if any
    std::vector<VertexIds> above_;  // by vertex: the skin vertices whose feet are on its triangles
    std::vector<VertexIds> rims_;   // of the walls: those vertices on the main, then on the
    std::vector<int> wall_of_rim_;  // opposite skin
};

}  // namespace sheetmorph::assembly

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::forms
{

//! A form feature with the triangles that touch it, as a small mesh of its own.
class FeaturePatch
{
public:
    //! \param vertices  of the feature, in any order, repeated or not
    //! \param scatter   standard deviation of the mesh's vertices, mm
    FeaturePatch(const mesh::TriangleMesh& mesh, const VertexIds& vertices, double scatter = 0.0);

    double scatter() const { return scatter_; }

    //! The feature's vertices and their neighbours; every index below is one of this mesh.
    const mesh::TriangleMesh& mesh() const { return mesh_; }

    const VertexIds& feature() const { return feature_; }  //!< each once
    const VertexIds& rows() const { return rows_; }        //!< as given to the constructor

    //! The closed loops that may be its rim, the shortest first: borders of the sheet inside it;
    //! without those, the borders of its triangles and the sharp edges among them; without
    //! triangles, its edges.
    const std::vector<VertexIds>& loops() const { return loops_; }

    //! Whether the loops are borders of the sheet.
    bool is_free() const { return is_free_; }

    //! Whether it fills the inside of its only loop.
    bool is_disk() const { return is_disk_; }

    //! The borders of the triangles whose corners are all among the vertices.
    std::vector<VertexIds> loops_of(const VertexIds& vertices) const;

    bool has_triangles(const VertexIds& vertices) const;
    VertexIds neighbours_of(const VertexIds& vertices) const;
    Points points_of(const VertexIds& vertices) const;

    //! Its own triangles, without vertices that are on none.
    mesh::TriangleMesh covered_mesh() const;

private:
    std::vector<char> marked(const VertexIds& vertices) const;
    Triangles triangles_among(const VertexIds& vertices) const;
    std::vector<VertexIds> border_loops() const;
    std::vector<VertexIds> edge_loop() const;
    void add_sharp_loops();
    double length_of(const VertexIds& loop) const;

    mesh::TriangleMesh mesh_;
    VertexIds feature_;
    VertexIds rows_;
    std::vector<VertexIds> loops_;
    bool is_disk_ = false;
    bool is_free_ = false;
    double scatter_ = 0.0;
};

}  // namespace sheetmorph::forms

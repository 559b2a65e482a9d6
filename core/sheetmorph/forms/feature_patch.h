// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::forms
{

//! A form feature and the triangles that touch it, extracted as a small mesh.
class FeaturePatch
{
public:
    //! \param vertices  of the feature, in any order; repetitions are allowed
    //! \param scatter   standard deviation of the mesh's vertices, mm
    FeaturePatch(const mesh::TriangleMesh& mesh, const VertexIds& vertices, double scatter = 0.0);

    double scatter() const { return scatter_; }

    //! The feature's vertices and their neighbours. All indices below refer to this mesh.
    const mesh::TriangleMesh& mesh() const { return mesh_; }

    const VertexIds& feature() const { return feature_; }  //!< without repetitions
    const VertexIds& rows() const { return rows_; }        //!< as given to the constructor

    //! Closed loops that can be the feature's rim, shortest first. These are the borders of the
    //! sheet inside the feature. If there are none, they are the borders of the feature's triangles
    //! and the sharp edges among them. Without triangles, they are its edges.
    const std::vector<VertexIds>& loops() const { return loops_; }

    //! Whether the loops are borders of the sheet.
    bool is_free() const { return is_free_; }

    //! Whether the feature fills the inside of its only loop.
    bool is_disk() const { return is_disk_; }

    //! The borders of the triangles whose corners are all among the vertices.
    std::vector<VertexIds> loops_of(const VertexIds& vertices) const;

    bool has_triangles(const VertexIds& vertices) const;
    VertexIds neighbours_of(const VertexIds& vertices) const;
    Points points_of(const VertexIds& vertices) const;

    //! The feature's own triangles, without unused vertices.
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/editable_triangles.h"

namespace sheetmorph::cad
{

using Vector2 = Eigen::Vector2d;

//! A vertex of a FaceMesh.
struct FaceVertex
{
    Vector2 uv = Vector2::Zero();      //!< parameters of the surface
    Vector3 point = Vector3::Zero();   //!< mm
    Vector3 normal = Vector3::Zero();  //!< of the surface, length 1; 0 where there is none
    double size = 0.0;                 //!< wanted edge length here, mm
    bool is_fixed = false;             //!< on an edge of the face
};

//! The triangles of one CAD face, counter-clockwise in its parameter plane.
//! The sides along the face's edges never change, so that neighbouring faces stay watertight.
class FaceMesh : public mesh::EditableTriangles
{
public:
    //! \param locked  sides (smaller vertex, larger vertex) that must stay though they lie inside
    //! \throws InvalidInput if a side has three triangles or two that run the same way
    FaceMesh(std::vector<FaceVertex> vertices, const std::vector<std::array<int, 3>>& triangles,
             std::vector<std::pair<int, int>> locked);

    const std::vector<FaceVertex>& vertices() const { return vertices_; }
    FaceVertex& vertex(int v) { return vertices_[static_cast<std::size_t>(v)]; }
    const FaceVertex& vertex(int v) const { return vertices_[static_cast<std::size_t>(v)]; }

    //! Puts a vertex on a free side. \returns its index
    int split(int t, int k, const FaceVertex& middle);

private:
    std::vector<FaceVertex> vertices_;
};

}  // namespace sheetmorph::cad

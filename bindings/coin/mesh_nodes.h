// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "shading.h"

class SoCoordinate3;
class SoIndexedFaceSet;
class SoNormal;

namespace sheetmorph::coin
{

//! Addresses of Coin nodes as pivy gives them: int(node.this).
struct NodeAddresses
{
    std::uintptr_t coordinates = 0;  //!< SoCoordinate3
    std::uintptr_t normals = 0;      //!< SoNormal, bound PER_VERTEX_INDEXED
    std::uintptr_t faces = 0;        //!< SoIndexedFaceSet
};

//! Where a mesh lies: the local position of a global one p is rotation^T (p - base).
struct Placing
{
    Matrix3 rotation = Matrix3::Identity();
    Vector3 base = Vector3::Zero();  //!< mm
};

//! Draws one mesh through three Coin nodes, which it keeps alive; a frame costs about as much as a
//! redraw.
class MeshNodes
{
public:
    //! Sets faces, positions and normals.
    //! \param points  (n, 3) mm; \param triangles (m, 3); \param crease radians, see corner_normals
    //! \throws std::invalid_argument if an address is no node of its type, or an index out of range
    MeshNodes(NodeAddresses nodes, const Points& points, const Triangles& triangles, double crease);
    ~MeshNodes();
    MeshNodes(const MeshNodes&) = delete;
    MeshNodes& operator=(const MeshNodes&) = delete;

    //! Shows other positions, (n, 3) mm, with their own normals; as they are, or made local.
    //! \throws std::invalid_argument if the number of rows is not the mesh's
    void show(const Eigen::Ref<const Points>& points) const;
    void show(const Eigen::Ref<const Points>& points, const Placing& placing);

private:
    void set_faces() const;

    Triangles triangles_;
    CornerNormals shading_;
    Eigen::Index vertex_count_;
    Points local_;  // of the last call, kept for its memory
    SoCoordinate3* coordinates_;
    SoNormal* normals_;
    SoIndexedFaceSet* faces_;
};

}  // namespace sheetmorph::coin

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! How well shaped the triangles of a mesh are; degenerate ones are counted and left out of the
//! rest.
struct MeshQuality
{
    double worst_angle_degrees = 60.0;  //!< smallest corner of any triangle
    double worst_aspect = 1.0;  //!< largest (longest edge / height over it), 1 if equilateral
    int degenerate = 0;         //!< triangles that repeat a vertex or are thinner than 1e-5
};

//! The quality of a mesh, in whatever shape its points are.
MeshQuality quality(const TriangleMesh& mesh);

//! By vertex the smallest corner of any triangle at it, degrees; 60 at a vertex without triangles.
Eigen::VectorXd vertex_quality(const TriangleMesh& mesh);

//! What a deformation did to the triangles.
struct QualityChange
{
    MeshQuality deformed;
    double largest_stretch = 1.0;   //!< largest edge length over its length at rest
    double smallest_stretch = 1.0;  //!< smallest of the same
    std::vector<int> flipped;       //!< triangles, ascending
};

//! Compares a deformed shape with the mesh at rest.
//!
//! A triangle is flipped if it was folded over onto a neighbour: across an edge they share the
//! sheet is bent by more than 150 degrees (between the planes: 0 flat, 180 one on the other), and
//! by at least 30 degrees more than at rest. Both triangles of such a pair are named, since the
//! pair does not tell which of them turned. Only angles between neighbours count: a mesh that is
//! turned as a whole, even upside down, has no flipped triangle, nor has a hem that was folded at
//! rest; and it does not matter how triangles are oriented. Degenerate triangles have no plane and
//! are left out. Edges without length at rest are left out of the stretches.
//!
//! \param points  (n, 3) deformed positions, mm
//! \throws InvalidInput if the number of points differs, or one is not finite
QualityChange compare_quality(const TriangleMesh& rest, const Points& points);

}  // namespace sheetmorph::mesh

// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! Shape quality of the triangles of a mesh. Degenerate triangles are only counted.
struct MeshQuality
{
    double worst_angle_degrees = 60.0;  //!< smallest corner angle of any triangle
    double worst_aspect = 1.0;  //!< largest ratio of longest edge to height, 1 if equilateral
    int degenerate = 0;         //!< triangles that repeat a vertex or are thinner than 1e-5
};

//! The quality of a mesh in any pose.
MeshQuality quality(const TriangleMesh& mesh);

//! The smallest corner angle of any triangle at each vertex, (n) degrees; 60 without triangles.
Eigen::VectorXd vertex_quality(const TriangleMesh& mesh);

//! Changes of the triangles under a deformation.
struct QualityChange
{
    MeshQuality deformed;
    double largest_stretch = 1.0;   //!< largest ratio of deformed to rest edge length
    double smallest_stretch = 1.0;  //!< smallest ratio
    std::vector<int> flipped;       //!< flipped triangles, ascending
};

//! Compares a deformed shape with the mesh at rest.
//!
//! A triangle counts as flipped if it is folded onto a neighbour. The bend across their common edge
//! (0: flat, 180: one on the other) then exceeds 150 degrees and is at least 30 degrees more than
//! at rest. Both triangles are listed, because the bend does not show which one flipped. Only bends
//! count: a mesh rotated as a whole, even upside down, has no flipped triangles, and neither has a
//! hem that was folded at rest. The orientation of the triangles has no effect. Degenerate
//! triangles have no plane and are ignored. Edges of zero length at rest have no stretch and are
//! ignored.
//!
//! \param points  (n, 3) deformed positions, mm
//! \throws InvalidInput if the number of points differs, or one is not finite
QualityChange compare_quality(const TriangleMesh& rest, const Points& points);

}  // namespace sheetmorph::mesh

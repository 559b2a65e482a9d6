// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <Eigen/SparseCore>
#include <array>

namespace sheetmorph::mesh
{

//! Half the cotangents of each triangle's corners, (m, 3): the weight of the edge opposite.
//! Signs are kept; a triangle that repeats a vertex or has no extent gives zeros, and one thinner
//! than 1e-4 of its longest edge is treated as just that thin, so that nothing is infinite; if a
//! vertex hangs on such triangles alone, they give zeros too and it belongs to no triangle.
Points half_cotangents(const TriangleMesh& mesh);

//! Cotangent stiffness K (n, n) of (2.1), positive semidefinite, no unit:
//! (K p)_i = 1/2 sum_j (cot a_ij + cot b_ij) (p_i - p_j); any number of triangles may share an
//! edge.
Eigen::SparseMatrix<double> cotangent_stiffness(const TriangleMesh& mesh,
                                                const Points& half_cotangents);

//! Stiffness with the same pattern whose edge weights are not negative: its harmonic functions
//! stay between their boundary values.
Eigen::SparseMatrix<double> non_negative_stiffness(const TriangleMesh& mesh,
                                                   const Points& half_cotangents);

//! Mixed Voronoi area of every vertex (n), mm^2 (Meyer et al. 2003); positive at every vertex of a
//! triangle, one at vertices of none (their rows of K are empty).
Eigen::VectorXd voronoi_areas(const TriangleMesh& mesh);

//! What one triangle adds to the areas of its corners, mm^2; zero if it has no extent.
Vector3 mixed_voronoi_shares(const std::array<Vector3, 3>& corners);

//! K p (n, 3), summed from edge vectors so that coordinates far from the origin lose no digits.
Points apply_stiffness(const TriangleMesh& mesh, const Points& half_cotangents,
                       const Points& points);

}  // namespace sheetmorph::mesh

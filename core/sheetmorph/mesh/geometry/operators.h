// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <Eigen/SparseCore>
#include <array>

namespace sheetmorph::mesh
{

//! Half the cotangents of each triangle's corners, (m, 3): its contribution to the weight of the
//! opposite edge. Signs are kept. A triangle that repeats a vertex or has no extent gives zeros. A
//! triangle thinner than 1e-4 of its longest edge counts as exactly that thin, so that values stay
//! finite. If only such triangles contain a vertex, they give zeros and the vertex is unused.
Points half_cotangents(const TriangleMesh& mesh);

//! Cotangent stiffness K (n, n) of (2.1), positive semidefinite, no unit:
//! (K p)_i = 1/2 sum_j (cot a_ij + cot b_ij) (p_i - p_j) .
//! Any number of triangles may share an edge.
Eigen::SparseMatrix<double> cotangent_stiffness(const TriangleMesh& mesh,
                                                const Points& half_cotangents);

//! Stiffness with the same pattern and non-negative edge weights: its harmonic functions stay
//! between their boundary values.
Eigen::SparseMatrix<double> non_negative_stiffness(const TriangleMesh& mesh,
                                                   const Points& half_cotangents);

//! Mixed Voronoi area of every vertex (n), mm^2 (Meyer et al. 2003). It is positive at every vertex
//! of a triangle. It is 1 at unused vertices, whose rows of K are empty.
Eigen::VectorXd voronoi_areas(const TriangleMesh& mesh);

//! The contribution of one triangle to the areas of its corners, mm^2; zero if it has no extent.
Vector3 mixed_voronoi_shares(const std::array<Vector3, 3>& corners);

//! K p (n, 3), summed from edge vectors to keep precision far from the origin.
Points apply_stiffness(const TriangleMesh& mesh, const Points& half_cotangents,
                       const Points& points);

}  // namespace sheetmorph::mesh

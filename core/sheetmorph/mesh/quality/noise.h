// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! How far the vertices of a measured mesh are scattered about its surface, as a standard deviation
//! in one direction, mm; 0 for a mesh that was drawn. A surface bends away from its vertices much
//! the same way as from their neighbours; scatter does not: what is left of the umbrella vector
//! (Taubin 1995) beside that of the neighbours, along the normal, tells it. Counted are vertices
//! amid smooth surface, and the calmer ones decide. \param normals  (m, 3) of length 1, or zero
double scatter_of(const TriangleMesh& mesh, const EdgeTable& edges, const Points& normals);

//! The same of a mesh whose vertices are merged.
double scatter_of(const TriangleMesh& mesh);

//! What scatter does to the normals of triangles with these areas (mm^2, 0: too thin): (m) radians.
std::vector<double> unsure_normals(const TriangleMesh& mesh, const std::vector<double>& areas,
                                   double scatter);

//! The normals of a mesh (m, 3) without what its scatter does to them: each is drawn to those
//! around it, the more the less they differ beyond what scatter explains, so that edges of the
//! shape stay sharp (bilateral normals, Zheng and others 2011).
//! \param normals  (m, 3); zero for a triangle too thin to have one, which stays so
Points calmed_normals(const EdgeTable& edges, const Points& normals,
                      const std::vector<double>& areas, const std::vector<double>& unsure);

}  // namespace sheetmorph::mesh

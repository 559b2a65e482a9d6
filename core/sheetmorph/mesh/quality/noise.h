// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

namespace sheetmorph::mesh
{

//! Standard deviation of a measured mesh's vertices about their surface in one direction, mm; 0 for
//! a drawn mesh. The estimate uses residuals of vertices from a quadric fitted to their two rings
//! of neighbours. Smooth surfaces follow the quadric, noise does not. Only vertices in smooth
//! regions count, and the lower quartile of the residuals decides.
//! \param normals  (m, 3) of length 1, or zero
double scatter_of(const TriangleMesh& mesh, const EdgeTable& edges, const Points& normals);

//! As above, for a mesh whose vertices are already merged.
double scatter_of(const TriangleMesh& mesh);

//! Standard deviation of the normals that scatter causes, (m) radians.
//! \param areas  (m) mm^2; 0: degenerate triangle
std::vector<double> unsure_normals(const TriangleMesh& mesh, const std::vector<double>& areas,
                                   double scatter);

//! The normals of a mesh (m, 3) with the effect of scatter removed. Each normal moves towards its
//! neighbours; the weight falls if they differ more than scatter explains, so that sharp edges stay
//! sharp (bilateral normal filtering, Zheng et al. 2011).
//! \param normals  (m, 3); zero for a degenerate triangle, which stays zero
Points calmed_normals(const EdgeTable& edges, const Points& normals,
                      const std::vector<double>& areas, const std::vector<double>& unsure);

}  // namespace sheetmorph::mesh

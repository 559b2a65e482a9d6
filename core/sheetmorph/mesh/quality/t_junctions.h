// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/boundary.h"

namespace sheetmorph::mesh
{

//! An open edge that runs through a vertex, where the triangles do not fit together.
struct TJunction
{
    int from, to;  //!< the open edge
    int vertex;    //!< nearer to the edge than the tolerance, farther from both ends
};

//! The T-junctions of a mesh, one per pair of open edge and vertex.
//! \param tolerance  mm, >= 0
std::vector<TJunction> t_junctions(const TriangleMesh& mesh, double tolerance);

//! The same for given edges of any kind.
std::vector<TJunction> junctions_on(const TriangleMesh& mesh,
                                    const std::vector<BoundaryEdge>& edges, double tolerance);

}  // namespace sheetmorph::mesh

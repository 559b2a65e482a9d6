// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::repair
{

//! How a mesh is made anew.
struct RemeshOptions
{
    double edge = 1.0;  //!< edge length wanted on flats, mm; shorter near rims, bends
    bool are_rims_on_circles = false;  //!< round rims go to their fitted circle, else stay polygons
    double crease_angle = 0.35;        //!< edges that bend by more are creases, radians
};

//! A mesh made anew on the facets of another, and where each of its vertices lies on them.
struct RemeshedMesh
{
    mesh::TriangleMesh mesh;
    std::vector<int> triangle;   //!< (n) the facet given that each vertex lies on
    Points barycentric;          //!< (n, 3) where on it; exact zeros on its edges and corners
    std::vector<int> vertex_of;  //!< (k) of every vertex given: the vertex in or nearest its place,
                                 //!< -1 if no triangle had it
    std::vector<char> is_kept;   //!< (k) whether that is exactly its place
    std::vector<int> patch;      //!< (m) the flat or curved region each triangle is part of
    int flats = 0;               //!< how many of these are flats
    int circles = 0;             //!< rims that were put on their circles
    double deviation = 0.0;      //!< farthest the new mesh is from the facets given, or they from
                                 //!< it: at vertices, middles of edges and of triangles, mm
    double flat_deviation = 0.0;   //!< the same on flats only
    double least_edge = 0.0;       //!< mm: no shorter edge was made, or there would have been too
                                   //!< many triangles for what was given; 0: all that were wanted
    Convergence convergence = {};  //!< of cutting, collapsing and turning its edges
};

//! Well-shaped triangles on the facets given. Creases, borders, rims and edges of three triangles
//! keep all their vertices; on curved regions the new vertices lie on the facets. The facets must
//! have no cuts they are not meant to have: see cured().
//! \throws InvalidInput for an edge length that is not positive, or so short that more than three
//!         million triangles would be needed, and for triangles that repeat a vertex; Cancelled
RemeshedMesh remeshed(const mesh::TriangleMesh& mesh, const RemeshOptions& options,
                      const Progress& progress = {});

}  // namespace sheetmorph::repair

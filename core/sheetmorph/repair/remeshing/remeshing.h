// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::repair
{

//! Options of remeshed().
struct RemeshOptions
{
    double edge = 1.0;  //!< target edge length on flats, mm; shorter near rims and bends
    bool are_rims_on_circles = false;  //!< round rims move to fitted circles, else stay polygons
    double crease_angle = 0.35;        //!< edges with a larger bend are creases, radians
};

//! A new mesh on the facets of another, with the position of each new vertex on them.
struct RemeshedMesh
{
    mesh::TriangleMesh mesh;
    std::vector<int> triangle;   //!< (n) the input facet that each vertex lies on
    Points barycentric;          //!< (n, 3) barycentric coordinates on it; exactly 0 on its edges
    std::vector<int> vertex_of;  //!< (k) by input vertex: nearest vertex; -1 if it was unused
    std::vector<char> is_kept;   //!< (k) whether that vertex is exactly in its place
    std::vector<int> patch;      //!< (m) the flat or curved region of each triangle
    int flats = 0;               //!< number of flats among these regions
    int circles = 0;             //!< number of rims moved to their circles
    double deviation = 0.0;  //!< largest distance between both meshes at vertices and middles, mm
    double flat_deviation = 0.0;   //!< the same on flats only
    double least_edge = 0.0;       //!< target edges were raised to this minimum, mm; 0: not needed
    Convergence convergence = {};  //!< of splitting, collapsing and flipping edges
};

//! Creates well-shaped triangles on the input facets. Creases, borders, rims and edges of three or
//! more triangles keep all their vertices. On curved regions the new vertices lie on the input
//! facets. The input must not have unintended cuts, see cured().
//! \throws InvalidInput for an edge length that is not positive or would need more than three
//!                      million triangles, and for triangles that repeat a vertex
//! \throws Cancelled on request
RemeshedMesh remeshed(const mesh::TriangleMesh& mesh, const RemeshOptions& options,
                      const Progress& progress = {});

}  // namespace sheetmorph::repair

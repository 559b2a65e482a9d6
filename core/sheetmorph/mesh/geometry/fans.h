// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/geometry/laid_faces.h"

namespace sheetmorph::mesh
{

//! The faces around every vertex, grouped into fans. Faces of a fan are connected by sides at the
//! vertex.
struct Fans
{
    std::vector<int> of_corner;     //!< (3 m) fan of corner 3 f + k, from 0
    std::vector<int> vertex;        //!< (fans) vertex of each fan
    std::vector<int> around;        //!< (n) number of fans at each vertex; 0 without faces
    std::vector<char> is_interior;  //!< (n) whether the vertex has one fan, glued all around
};

//! \param vertex_count  n
Fans fans_of(const LaidFaces& faces, int vertex_count);

//! Groups of two or more open sides on the same edge, where several sheets meet.
std::vector<std::vector<int>> seams_of(const LaidFaces& faces);

}  // namespace sheetmorph::mesh

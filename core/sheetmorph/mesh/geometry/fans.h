// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/geometry/laid_faces.h"

namespace sheetmorph::mesh
{

//! The faces around every vertex, in fans: groups that hang together by the sides they share there.
struct Fans
{
    std::vector<int> of_corner;     //!< (3 m) 0.. the fan of corner 3 f + k
    std::vector<int> vertex;        //!< (fans)
    std::vector<int> around;        //!< (n) fans at each vertex; 0 if no face has it
    std::vector<char> is_interior;  //!< (n) one fan, glued all around
};

//! \param vertex_count  n
Fans fans_of(const LaidFaces& faces, int vertex_count);

//! Open sides that lie on the same edge, two or more each: where several sheets meet.
std::vector<std::vector<int>> seams_of(const LaidFaces& faces);

}  // namespace sheetmorph::mesh

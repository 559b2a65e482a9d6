// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <array>

namespace sheetmorph::mesh
{

//! The triangles of a mesh, each laid flat in a frame of its own and glued to its neighbours along
//! sides. Side s = 3 f + k runs from corner k of face f to the next. The faces need not be those of
//! the mesh: delaunay_flips() turns sides inside the sheet, unfolded as if it were paper.
struct LaidFaces
{
    static constexpr int open = -1;

    //! Where a face's corners are, mm; only their differences count. Two faces agree on the length
    //! of the side they share, not on its direction.
    using Corners = std::array<Vector3, 3>;

    Triangles triangles;           //!< (m, 3) vertices; a flipped face may meet a vertex twice
    std::vector<Corners> corners;  //!< (m)
    std::vector<int> glued;        //!< (3 m) the side of the neighbour, or open
    std::vector<int> rim;          //!< (3 m) open sides on one edge of the mesh share a number
    double share = 1.0;            //!< of the sheet in a face: 1/2 in a double cover

    int count() const { return static_cast<int>(triangles.rows()); }
    int from(int side) const { return triangles(side / 3, side % 3); }
    int to(int side) const { return triangles(side / 3, (side % 3 + 1) % 3); }
    int apex(int side) const { return triangles(side / 3, (side % 3 + 2) % 3); }
};

//! The triangles as they are, glued where exactly two meet. A triangle given twice counts once; one
//! that repeats a vertex, or hangs on degenerate triangles alone, not at all; one thinner than 1e-4
//! of its longest side is laid just that thin, so that nothing is infinite.
LaidFaces laid_faces(const TriangleMesh& mesh);

//! The same, or where three or more triangles meet on an edge the double cover: every triangle has
//! a front and a back, and around an edge each face is glued to the next one that looks at it
//! (Sharp and Crane 2020), so that the faces are glued in pairs everywhere inside the mesh.
LaidFaces covered_faces(const TriangleMesh& mesh);

//! Cotangent of a face's angle at a corner (0 to 2).
double corner_cotangent(const LaidFaces::Corners& corners, int corner);

//! Area of a face, mm^2.
double face_area(const LaidFaces::Corners& corners);

}  // namespace sheetmorph::mesh

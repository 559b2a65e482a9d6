// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <array>

namespace sheetmorph::mesh
{

//! An intrinsic triangulation: the triangles of a mesh, each laid flat in its own frame and glued
//! to its neighbours along sides. Side s = 3 f + k runs from corner k of face f to the next. The
//! faces can differ from the mesh: flip_to_delaunay() flips sides within the sheet, unfolded like
//! paper.
struct LaidFaces
{
    static constexpr int open = -1;

    //! Corner positions of a face, mm. Only their differences matter: two faces agree on the length
    //! of their common side but not on its direction.
    using Corners = std::array<Vector3, 3>;

    Triangles triangles;           //!< (m, 3) vertices; a flipped face may repeat a vertex
    std::vector<Corners> corners;  //!< (m)
    std::vector<int> glued;        //!< (3 m) side of the neighbour, or open
    std::vector<int> rim;  //!< (3 m) a common number for the open sides on one edge of the mesh
    double share = 1.0;    //!< share of the sheet per face: 1/2 in a double cover

    int count() const { return static_cast<int>(triangles.rows()); }
    int from(int side) const { return triangles(side / 3, side % 3); }
    int to(int side) const { return triangles(side / 3, (side % 3 + 1) % 3); }
    int apex(int side) const { return triangles(side / 3, (side % 3 + 2) % 3); }
};

//! The original triangles, glued where exactly two meet. Duplicate triangles count once. Triangles
//! that repeat a vertex are omitted, and so are triangles with a vertex that only degenerate
//! triangles contain. A triangle thinner than 1e-4 of its longest side is laid with that height, so
//! that cotangents stay finite.
LaidFaces laid_faces(const TriangleMesh& mesh);

//! As laid_faces(), except where three or more triangles meet at an edge. Then it is the double
//! cover: every triangle has a front and a back. Around an edge, each face is glued to the next one
//! that faces it (Sharp and Crane 2020). All sides inside the mesh are then glued in pairs.
LaidFaces covered_faces(const TriangleMesh& mesh);

//! Cotangent of a face's angle at a corner (0 to 2).
double corner_cotangent(const LaidFaces::Corners& corners, int corner);

//! Area of a face, mm^2.
double face_area(const LaidFaces::Corners& corners);

}  // namespace sheetmorph::mesh

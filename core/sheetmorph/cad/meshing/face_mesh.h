// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/types.h"

#include <array>
#include <cstdint>
#include <unordered_set>

namespace sheetmorph
{

using Vector2 = Eigen::Vector2d;

//! A vertex of a FaceMesh.
struct FaceVertex
{
    Vector2 uv = Vector2::Zero();      //!< parameters of the surface
    Vector3 point = Vector3::Zero();   //!< mm
    Vector3 normal = Vector3::Zero();  //!< of the surface, length 1; 0 where there is none
    double size = 0.0;                 //!< wanted edge length here, mm
    bool is_fixed = false;             //!< on an edge of the face
    int triangle = -1;                 //!< one of those around it
};

//! A triangle of a FaceMesh: its corners run counter-clockwise in the parameter plane.
struct FaceTriangle
{
    std::array<int, 3> corner = {-1, -1, -1};
    std::array<int, 3> across = {-1, -1, -1};  //!< over the side from corner k to the next; or -1

    bool is_alive() const { return corner[0] >= 0; }
};

//! The triangles of one CAD face in its parameter plane, and the operations that remesh it.
//! The sides along the face's edges never change, so that neighbouring faces stay watertight.
class FaceMesh
{
public:
    //! \param locked  sides (smaller vertex, larger vertex) that must stay though they lie inside
    //! \throws InvalidInput if a side has three triangles or two that run the same way
    FaceMesh(std::vector<FaceVertex> vertices, const std::vector<std::array<int, 3>>& triangles,
             const std::vector<std::array<int, 2>>& locked);

    const std::vector<FaceVertex>& vertices() const { return vertices_; }
    const std::vector<FaceTriangle>& triangles() const { return triangles_; }
    FaceVertex& vertex(int v) { return vertices_[static_cast<std::size_t>(v)]; }
    const FaceVertex& vertex(int v) const { return vertices_[static_cast<std::size_t>(v)]; }
    const FaceTriangle& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }

    //! Whether side k of a triangle may be split and flipped.
    bool is_free_side(int t, int k) const;

    //! The vertex over side k of a triangle.
    int opposite(int t, int k) const;

    //! The triangles around a vertex that is not fixed.
    std::vector<int> around(int v) const;

    //! Puts a vertex on a free side. \returns its index
    int split(int t, int k, const FaceVertex& middle);

    //! Exchanges a free side for the other diagonal of its two triangles.
    void flip(int t, int k);

    //! Removes vertex `v`, not fixed, by moving it onto its neighbour `to`; triangles die.
    void collapse(int v, int to);

private:
    // Triangles (a, b, c) and, across its side (a, b), (b, a, d); and what lies over their sides.
    struct Diamond
    {
        int other = -1;
        int a = -1, b = -1, c = -1, d = -1;
        int bc = -1, ca = -1, ad = -1, db = -1;
    };

    Diamond diamond(int t, int k) const;
    FaceTriangle& at(int t) { return triangles_[static_cast<std::size_t>(t)]; }
    void connect();
    void set_triangle(int t, const FaceTriangle& triangle);
    void relink(int t, int before, int after);
    int side_of(int t, int from, int to) const;
    bool is_locked(int a, int b) const;

    std::vector<FaceVertex> vertices_;
    std::vector<FaceTriangle> triangles_;
    std::unordered_set<std::uint64_t> locked_;
};

}  // namespace sheetmorph

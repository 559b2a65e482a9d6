// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

#include <array>
#include <string>
#include <utility>

namespace sheetmorph::mesh
{

//! Triangles with operations for remeshing: split, flip and collapse. The class stores only corners
//! and neighbours; the caller stores the positions.
class EditableTriangles
{
public:
    struct Triangle
    {
        std::array<int, 3> corner = {-1, -1, -1};
        //! Across the side from corner k to the next; -1 at a border or cut.
        std::array<int, 3> across = {-1, -1, -1};

        bool is_alive() const { return corner[0] >= 0; }
    };

    //! Neighbours share a side that has exactly two triangles and run along it in opposite
    //! directions.
    //! \param cuts  sides without neighbours (smaller vertex, larger vertex), sorted; they stay
    //!              unchanged
    EditableTriangles(const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& cuts);

    //! Whether there are duplicate triangles, sides of three triangles, or inconsistent
    //! orientations.
    bool has_clash() const { return has_clash_; }

    int count() const { return static_cast<int>(triangles_.size()); }
    int vertex_count() const { return static_cast<int>(triangle_at_.size()); }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    const Triangle& triangle(int t) const { return triangles_[index(t)]; }
    int corner(int t, int k) const { return triangle(t).corner[index(k % 3)]; }
    int across(int t, int k) const { return triangle(t).across[index(k % 3)]; }

    //! The corner of a triangle at a vertex; -1 if it does not contain the vertex.
    int corner_of(int t, int v) const;

    //! One of the triangles at a vertex; -1 without one.
    int triangle_at(int v) const { return triangle_at_[index(v)]; }

    //! Whether side k of a triangle may be split and flipped.
    bool is_free_side(int t, int k) const { return across(t, k) >= 0; }

    //! The apex of the neighbour across free side k.
    int opposite(int t, int k) const;

    //! The triangles at a vertex that are connected to one of them across sides at the vertex.
    std::vector<int> fan(int t, int v) const;
    std::vector<int> around(int v) const { return fan(triangle_at(v), v); }

    //! The neighbours of a vertex within fan(), sorted.
    std::vector<int> neighbours(int t, int v) const;

    //! Inserts a vertex on a free side and appends two triangles.
    //! \returns index of the vertex
    int split(int t, int k);

    //! Whether flip() keeps the surface manifold: the other diagonal is not yet a side, and the
    //! ends of this side keep three triangles each, or one at a border.
    bool may_flip(int t, int k) const;

    //! Replaces a free side by the other diagonal of its two triangles. Requires may_flip().
    void flip(int t, int k);

    //! Whether collapse() of side k keeps the surface manifold (Dey et al. 1999). The ends must
    //! share only the two opposite vertices and the two triangles at the side. The opposite
    //! vertices must keep three triangles, or one at a border.
    bool may_collapse(int t, int k) const;

    //! Removes vertex `v`, whose triangles must form a closed fan, by moving it onto its neighbour
    //! `to`. Requires may_collapse(). Two triangles disappear.
    void collapse(int v, int to);

    //! Describes an inconsistency between neighbours; empty if there is none. Tests call it after
    //! every step.
    std::string fault() const;

    //! Calls work(t, k) once for every side between two triangles, and for every side without a
    //! neighbour.
    template <typename Work>
    void for_each_side(Work&& work) const
    {
        const int now = count();
        for (int t = 0; t < now; ++t)
            for (int k = 0; k < 3 && triangle(t).is_alive(); ++k)
                if (across(t, k) < t)
                    work(t, k);
    }

private:
    // Triangles (a, b, c) and, across side (a, b), (b, a, d), and their outer neighbours.
    struct Diamond
    {
        int other, a, b, c, d, bc, ca, ad, db;
    };

    static std::size_t index(int k) { return static_cast<std::size_t>(k); }
    bool keeps_three(int t, int v) const;
    Diamond diamond(int t, int k) const;
    void set_triangle(int t, const Triangle& triangle);
    void relink(int t, int before, int after);

    std::vector<Triangle> triangles_;
    std::vector<int> triangle_at_;  // by vertex
    bool has_clash_ = false;
};

}  // namespace sheetmorph::mesh

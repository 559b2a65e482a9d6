// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/topology/edges.h"

#include <array>
#include <string>
#include <utility>

namespace sheetmorph::mesh
{

//! Triangles whose sides can be split and exchanged and whose vertices can be removed, as remeshing
//! does. It knows corners and neighbours; where the vertices lie is the caller's.
class EditableTriangles
{
public:
    struct Triangle
    {
        std::array<int, 3> corner = {-1, -1, -1};
        std::array<int, 3> across = {-1, -1, -1};  //!< over the side from corner k to the next;
                                                   //!< -1 where the triangles end or are cut

        bool is_alive() const { return corner[0] >= 0; }
    };

    //! Neighbours are those that share a side of two triangles and run along it either way.
    //! \param cuts  sides that must stay (smaller vertex, larger vertex), sorted: none are
    //!              neighbours over them
    EditableTriangles(const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& cuts);

    //! Whether a triangle stands twice, three share a side, or two run along one the same way.
    bool has_clash() const { return has_clash_; }

    int count() const { return static_cast<int>(triangles_.size()); }
    int vertex_count() const { return static_cast<int>(triangle_at_.size()); }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    const Triangle& triangle(int t) const { return triangles_[index(t)]; }
    int corner(int t, int k) const { return triangle(t).corner[index(k % 3)]; }
    int across(int t, int k) const { return triangle(t).across[index(k % 3)]; }

    //! Which corner of a triangle a vertex is; -1 if it is none.
    int corner_of(int t, int v) const;

    //! One of the triangles at a vertex; -1 if there is none.
    int triangle_at(int v) const { return triangle_at_[index(v)]; }

    //! Whether side k of a triangle may be split and exchanged.
    bool is_free_side(int t, int k) const { return across(t, k) >= 0; }

    //! The vertex over free side k of a triangle.
    int opposite(int t, int k) const;

    //! The triangles at a vertex that can be reached from one of them without leaving it.
    std::vector<int> fan(int t, int v) const;
    std::vector<int> around(int v) const { return fan(triangle_at(v), v); }

    //! The vertices beside one, of the triangles of fan(), sorted.
    std::vector<int> neighbours(int t, int v) const;

    //! Puts a vertex on a free side; two triangles come last. \returns its index
    int split(int t, int k);

    //! Whether flip() keeps a surface: the other diagonal is no side yet, and the ends of this one
    //! keep three triangles each.
    bool may_flip(int t, int k) const;

    //! Exchanges a free side for the other diagonal of its two triangles, which may_flip() allows.
    void flip(int t, int k);

    //! Whether collapse() over side k of a triangle keeps a surface: its ends have no neighbours in
    //! common but the vertices opposite that side, no triangles in common but those beside it, and
    //! the vertices opposite keep three triangles, or two at a border (Dey et al. 1999).
    bool may_collapse(int t, int k) const;

    //! Removes vertex `v`, around which triangles close, by moving it onto its neighbour `to`,
    //! which may_collapse() allows; triangles die.
    void collapse(int v, int to);

    //! What is wrong with the neighbours of the triangles, empty if nothing: for tests, which check
    //! it after every step.
    std::string fault() const;

    //! work(t, k) for every side once, for those without neighbour from either triangle.
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
    // Triangles (a, b, c) and, across its side (a, b), (b, a, d); and what lies over their sides.
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/editable_triangles.h"

#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>
#include <iterator>

namespace sheetmorph::mesh
{

EditableTriangles::EditableTriangles(const TriangleMesh& mesh,
                                     const std::vector<std::pair<int, int>>& cuts)
    : triangles_(static_cast<std::size_t>(mesh.triangle_count())),
      triangle_at_(static_cast<std::size_t>(mesh.vertex_count()), -1)
{
    const EdgeTable table(mesh);
    for (int t = 0; t < count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            triangles_[index(t)].corner[index(k)] = mesh.triangles()(t, k);
            triangle_at_[index(mesh.triangles()(t, k))] = t;
            has_clash_ = has_clash_ || table.edge_of(t, k) < 0;
        }
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const EdgeUses uses = table.uses(edge);
        const EdgeUse &one = *uses.begin(), &other = *(uses.end() - 1);
        const bool is_clash = uses.count() > 2 || (uses.count() == 2 && one.from == other.from);
        has_clash_ = has_clash_ || is_clash;
        if (uses.count() != 2 || is_clash
            || std::binary_search(
                cuts.begin(), cuts.end(),
                std::pair(std::min(one.from, one.to), std::max(one.from, one.to))))
            continue;
        triangles_[index(one.triangle)].across[index(corner_of(one.triangle, one.from))] =
            other.triangle;
        triangles_[index(other.triangle)].across[index(corner_of(other.triangle, other.from))] =
            one.triangle;
    }
}

int EditableTriangles::corner_of(int t, int v) const
{
    const auto& corners = triangle(t).corner;
    const auto found = std::find(corners.begin(), corners.end(), v);
    return found == corners.end() ? -1 : static_cast<int>(found - corners.begin());
}

int EditableTriangles::opposite(int t, int k) const
{
    const int other = across(t, k);
    return corner(other, corner_of(other, corner(t, k)) + 1);
}

std::vector<int> EditableTriangles::fan(int t, int v) const
{
    std::vector<int> found;
    int here = t;
    do
    {
        found.push_back(here);
        here = across(here, corner_of(here, v) + 2);
    } while (here != t && here >= 0);
    if (here == t)
        return found;
    for (here = across(t, corner_of(t, v)); here >= 0; here = across(here, corner_of(here, v)))
        found.push_back(here);
    return found;
}

void EditableTriangles::set_triangle(int t, const Triangle& triangle)
{
    triangles_[index(t)] = triangle;
    for (const int v : triangle.corner)
        triangle_at_[index(v)] = t;
}

void EditableTriangles::relink(int t, int before, int after)
{
    if (t < 0)
        return;
    auto& across = triangles_[index(t)].across;
    const auto found = std::find(across.begin(), across.end(), before);
    if (found != across.end())
        *found = after;
}

EditableTriangles::Diamond EditableTriangles::diamond(int t, int k) const
{
    const int other = across(t, k), j = corner_of(other, corner(t, k + 1));
    return {other,
            corner(t, k),
            corner(t, k + 1),
            corner(t, k + 2),
            corner(other, j + 2),
            across(t, k + 1),
            across(t, k + 2),
            across(other, j + 1),
            across(other, j + 2)};
}

int EditableTriangles::split(int t, int k)
{
    const auto [o, a, b, c, d, bc, ca, ad, db] = diamond(t, k);
    const int m = vertex_count(), t2 = count(), o2 = t2 + 1;
    triangle_at_.push_back(t);
    triangles_.resize(triangles_.size() + 2);
    set_triangle(t, {{a, m, c}, {o, t2, ca}});
    set_triangle(t2, {{m, b, c}, {o2, bc, t}});
    set_triangle(o, {{m, a, d}, {t, ad, o2}});
    set_triangle(o2, {{b, m, d}, {t2, o, db}});
    relink(bc, t, t2);
    relink(db, o, o2);
    return m;
}

// Whether a vertex of a triangle can lose a triangle: it has more than three, or more than one at a
// border.
bool EditableTriangles::keeps_three(int t, int v) const
{
    int here = t, count = 0;
    do
    {
        ++count;
        here = across(here, corner_of(here, v) + 2);
    } while (here != t && here >= 0);
    return here == t ? count > 3 : fan(t, v).size() > 1;
}

std::vector<int> EditableTriangles::neighbours(int t, int v) const
{
    std::vector<int> found;
    for (const int one : fan(t, v))
        for (const int other : triangle(one).corner)
            if (other != v)
                found.push_back(other);
    make_set(found);
    return found;
}

bool EditableTriangles::may_flip(int t, int k) const
{
    const int left = corner(t, k + 2), right = opposite(t, k);
    if (left == right || !keeps_three(t, corner(t, k)) || !keeps_three(t, corner(t, k + 1)))
        return false;
    const std::vector<int> beside = neighbours(t, left);
    return !std::binary_search(beside.begin(), beside.end(), right);
}

bool EditableTriangles::may_collapse(int t, int k) const
{
    const int a = corner(t, k), b = corner(t, k + 1), other = across(t, k);
    const int left = corner(t, k + 2), right = opposite(t, k);
    int both = 0;
    for (const int one : fan(t, a))
        both += corner_of(one, b) >= 0;
    if (left == right || both != 2 || !keeps_three(t, left) || !keeps_three(other, right))
        return false;
    const std::vector<int> beside_a = neighbours(t, a), beside_b = neighbours(t, b);
    std::vector<int> common;
    std::set_intersection(beside_a.begin(), beside_a.end(), beside_b.begin(), beside_b.end(),
                          std::back_inserter(common));
    return common.size() == 2;
}

void EditableTriangles::flip(int t, int k)
{
    const auto [o, a, b, c, d, bc, ca, ad, db] = diamond(t, k);
    set_triangle(t, {{c, a, d}, {ca, ad, o}});
    set_triangle(o, {{d, b, c}, {db, bc, t}});
    relink(bc, t, o);
    relink(ad, o, t);
}

void EditableTriangles::collapse(int v, int to)
{
    for (const int t : around(v))
    {
        const int k = corner_of(t, v), at_to = corner_of(t, to);
        if (at_to < 0)
        {
            triangles_[index(t)].corner[index(k)] = to;
            triangle_at_[index(to)] = t;
            continue;
        }
        // The sides at `v` and at `to` merge, so their outer neighbours become adjacent.
        const int third = 3 - k - at_to;
        const int outer = across(t, (at_to + 1) % 3 == third ? at_to : third);
        const int inner = across(t, (k + 1) % 3 == third ? k : third);
        relink(outer, t, inner);
        relink(inner, t, outer);
        const int kept = outer >= 0 ? outer : inner;
        triangle_at_[index(corner(t, third))] = kept;
        triangle_at_[index(to)] = kept;
        triangles_[index(t)].corner.fill(-1);
    }
    triangle_at_[index(v)] = -1;
}

std::string EditableTriangles::fault() const
{
    for (int t = 0; t < count(); ++t)
        for (int k = 0; k < 3 && triangle(t).is_alive(); ++k)
        {
            const int a = corner(t, k), b = corner(t, k + 1), other = across(t, k);
            const std::string place =
                "side " + std::to_string(k) + " of triangle " + std::to_string(t);
            if (a < 0 || a >= vertex_count() || a == b)
                return place + " has no two vertices";
            if (triangle_at(a) < 0 || corner_of(triangle_at(a), a) < 0)
                return "vertex " + std::to_string(a) + " has lost its triangle";
            if (other < 0)
                continue;
            if (other == t || other >= count() || !triangle(other).is_alive()
                || corner_of(other, a) < 0 || corner_of(other, b) < 0)
                return place + " has a neighbour that is not there";
            const auto& back = triangle(other).across;
            if (std::count(back.begin(), back.end(), t) == 0)
                return place + " has a neighbour that has another one";
        }
    for (int v = 0; v < vertex_count(); ++v)
        if (triangle_at(v) >= 0 && corner_of(triangle_at(v), v) < 0)
            return "vertex " + std::to_string(v) + " is at a triangle without it";
    return {};
}

}  // namespace sheetmorph::mesh

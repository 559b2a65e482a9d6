// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/face_mesh.h"
#include "sheetmorph/base/errors.h"

#include <algorithm>
#include <unordered_map>

namespace sheetmorph
{

namespace
{

std::uint64_t key_of(int a, int b)
{
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32)
           | static_cast<std::uint32_t>(b);
}

constexpr int next(int k)
{
    return (k + 1) % 3;
}

int corner_at(const FaceTriangle& triangle, int k)
{
    return triangle.corner[static_cast<std::size_t>(k)];
}

int across_at(const FaceTriangle& triangle, int k)
{
    return triangle.across[static_cast<std::size_t>(k)];
}

}  // namespace

FaceMesh::FaceMesh(std::vector<FaceVertex> vertices,
                   const std::vector<std::array<int, 3>>& triangles,
                   const std::vector<std::array<int, 2>>& locked)
    : vertices_(std::move(vertices))
{
    for (const auto& [a, b] : locked)
        locked_.insert(key_of(std::min(a, b), std::max(a, b)));
    for (const auto& corners : triangles)
        triangles_.push_back({corners, {-1, -1, -1}});
    connect();
}

void FaceMesh::connect()
{
    std::unordered_map<std::uint64_t, std::pair<int, int>> sides;
    const int count = static_cast<int>(triangles_.size());
    for (int t = 0; t < count; ++t)
        for (int k = 0; k < 3; ++k)
        {
            const FaceTriangle& here = triangle(t);
            const std::uint64_t key = key_of(corner_at(here, k), corner_at(here, next(k)));
            if (!sides.emplace(key, std::make_pair(t, k)).second)
                throw InvalidInput("two triangles of a face have the same side");
            vertex(corner_at(here, k)).triangle = t;
        }
    for (int t = 0; t < count; ++t)
        for (int k = 0; k < 3; ++k)
        {
            const FaceTriangle& here = triangle(t);
            const auto found = sides.find(key_of(corner_at(here, next(k)), corner_at(here, k)));
            at(t).across[static_cast<std::size_t>(k)] =
                found == sides.end() ? -1 : found->second.first;
        }
}

bool FaceMesh::is_locked(int a, int b) const
{
    return locked_.count(key_of(std::min(a, b), std::max(a, b))) > 0;
}

bool FaceMesh::is_free_side(int t, int k) const
{
    const FaceTriangle& here = triangle(t);
    return across_at(here, k) >= 0 && !is_locked(corner_at(here, k), corner_at(here, next(k)));
}

int FaceMesh::side_of(int t, int from, int to) const
{
    const FaceTriangle& here = triangle(t);
    for (int k = 0; k < 3; ++k)
        if (corner_at(here, k) == from && corner_at(here, next(k)) == to)
            return k;
    return -1;
}

int FaceMesh::opposite(int t, int k) const
{
    const FaceTriangle& here = triangle(t);
    const int other = across_at(here, k);
    const int j = side_of(other, corner_at(here, next(k)), corner_at(here, k));
    return corner_at(triangle(other), next(next(j)));
}

std::vector<int> FaceMesh::around(int v) const
{
    std::vector<int> found;
    const int first = vertex(v).triangle;
    int t = first;
    do
    {
        found.push_back(t);
        const FaceTriangle& here = triangle(t);
        const int k = corner_at(here, 0) == v ? 0 : corner_at(here, 1) == v ? 1 : 2;
        t = across_at(here, next(next(k)));
    } while (t != first && t >= 0);
    return found;
}

void FaceMesh::set_triangle(int t, const FaceTriangle& triangle)
{
    at(t) = triangle;
    for (const int v : triangle.corner)
        vertex(v).triangle = t;
}

void FaceMesh::relink(int t, int before, int after)
{
    if (t < 0)
        return;
    for (int& other : at(t).across)
        if (other == before)
        {
            other = after;
            return;
        }
}

FaceMesh::Diamond FaceMesh::diamond(int t, int k) const
{
    const FaceTriangle one = triangle(t);
    Diamond found;
    found.other = across_at(one, k);
    const FaceTriangle other = triangle(found.other);
    found.a = corner_at(one, k);
    found.b = corner_at(one, next(k));
    found.c = corner_at(one, next(next(k)));
    const int j = side_of(found.other, found.b, found.a);
    found.d = corner_at(other, next(next(j)));
    found.bc = across_at(one, next(k));
    found.ca = across_at(one, next(next(k)));
    found.ad = across_at(other, next(j));
    found.db = across_at(other, next(next(j)));
    return found;
}

int FaceMesh::split(int t, int k, const FaceVertex& middle)
{
    const auto [o, a, b, c, d, bc, ca, ad, db] = diamond(t, k);
    const int m = static_cast<int>(vertices_.size());
    vertices_.push_back(middle);
    const int t2 = static_cast<int>(triangles_.size());
    const int o2 = t2 + 1;
    triangles_.resize(triangles_.size() + 2);
    set_triangle(t, {{a, m, c}, {o, t2, ca}});
    set_triangle(t2, {{m, b, c}, {o2, bc, t}});
    set_triangle(o, {{m, a, d}, {t, ad, o2}});
    set_triangle(o2, {{b, m, d}, {t2, o, db}});
    relink(bc, t, t2);
    relink(db, o, o2);
    return m;
}

void FaceMesh::flip(int t, int k)
{
    const auto [o, a, b, c, d, bc, ca, ad, db] = diamond(t, k);
    set_triangle(t, {{c, a, d}, {ca, ad, o}});
    set_triangle(o, {{d, b, c}, {db, bc, t}});
    relink(bc, t, o);
    relink(ad, o, t);
}

void FaceMesh::collapse(int v, int to)
{
    for (const int t : around(v))
    {
        const FaceTriangle here = triangle(t);
        const auto& corners = here.corner;
        const int k =
            static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
        if (std::find(corners.begin(), corners.end(), to) == corners.end())
        {
            at(t).corner[static_cast<std::size_t>(k)] = to;
            vertex(to).triangle = t;
            continue;
        }
        // The sides at `v` and at `to` become one; their neighbours meet there.
        const int at_to = corner_at(here, next(k)) == to ? next(k) : next(next(k));
        const int third = 3 - k - at_to;
        const int far = next(at_to) == third ? at_to : third;
        const int near = next(k) == third ? k : third;
        const int outer = across_at(here, far), inner = across_at(here, near);
        relink(outer, t, inner);
        relink(inner, t, outer);
        at(t).corner.fill(-1);
        const int kept = outer >= 0 ? outer : inner;
        vertex(corner_at(here, third)).triangle = kept;
        vertex(to).triangle = kept;
    }
    vertex(v).triangle = -1;
}

}  // namespace sheetmorph

// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of adaptive isotropic remeshing (Botsch, Kobbelt 2004; Dunyach et al. 2013), with the
// topological operations of CGAL.
#include "sheetmorph/repair/remeshing/sizes.h"
#include "sheetmorph/repair/remeshing/working_mesh.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace sheetmorph
{

namespace
{

using Vertex = WorkingMesh::Vertex;
using Halfedge = WorkingMesh::Halfedge;
using Edge = WorkingMesh::Edge;
using Face = WorkingMesh::Face;

constexpr double too_long = 4.0 / 3.0;
constexpr double too_short = 4.0 / 5.0;
constexpr double least_height = 0.02;    // over the longest edge, of a triangle that is made
constexpr double least_alignment = 0.8;  // cosine between a triangle before and after a step

// Whether a triangle keeps its side, and keeps some height.
bool is_sound(const Vector3& before, const Vector3& after)
{
    const double product = before.norm() * after.norm();
    return product > 0.0 && before.dot(after) > least_alignment * product;
}

double height_ratio(const Vector3& a, const Vector3& b, const Vector3& c)
{
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest > 0.0 ? WorkingMesh::area_vector(a, b, c).norm() / longest : 0.0;
}

double cotangent_at(const Vector3& apex, const Vector3& a, const Vector3& b)
{
    const Vector3 to_a = a - apex, to_b = b - apex;
    return to_a.dot(to_b) / std::max(to_a.cross(to_b).norm(), 1e-300);
}

bool flip_if_better(WorkingMesh& work, Edge e)
{
    auto& surface = work.surface;
    const Halfedge h = surface.halfedge(e), o = surface.opposite(h);
    const Vertex from = surface.source(h), to = surface.target(h);
    const Vertex left = surface.target(surface.next(h)), right = surface.target(surface.next(o));
    const Vector3 a = work.point(from), b = work.point(to);
    const Vector3 c = work.point(left), d = work.point(right);
    // Two angles sum up to more than pi where their cotangents sum up to less than 0.
    if (!(cotangent_at(c, a, b) + cotangent_at(d, a, b) < -1e-7) || left == right)
        return false;
    // The pair as one area: its triangles may be thin, and a thin one has no side of its own.
    const Vector3 pair = WorkingMesh::area_vector(a, b, c) + WorkingMesh::area_vector(b, a, d);
    if (!is_sound(pair, WorkingMesh::area_vector(a, d, c))
        || !is_sound(pair, WorkingMesh::area_vector(d, b, c)))
        return false;
    if (surface.halfedge(left, right) != WorkingMesh::SurfaceMesh::null_halfedge())
        return false;
    CGAL::Euler::flip_edge(h, surface);
    return true;
}

void split(WorkingMesh& work, Edge e)
{
    auto& surface = work.surface;
    const Halfedge h = surface.halfedge(e);
    const Vertex a = surface.source(h), b = surface.target(h);
    const Vector3 middle = 0.5 * (work.point(a) + work.point(b));
    const double half = 0.5 * work.length(e);
    const double size = std::min({work.size[a] + size_growth * half,
                                  work.size[b] + size_growth * half, work.largest_size(e)});
    const Halfedge fresh = CGAL::Euler::split_edge(h, surface);
    const Vertex v = surface.target(fresh);
    work.move(v, middle);
    work.size[v] = size;
    const Halfedge back = surface.opposite(fresh);
    const auto cut = [&](Halfedge one, Halfedge other)
    {
        const Halfedge inner = CGAL::Euler::split_face(one, other, surface);
        const Face p = surface.face(inner), q = surface.face(surface.opposite(inner));
        work.patch[p] = work.patch[q] = std::max(work.patch[p], work.patch[q]);
    };
    cut(fresh, surface.next(surface.next(fresh)));
    cut(surface.prev(back), surface.next(back));
}

// Whether the triangles around a vertex keep their sides when it goes to a place; those that
// `gone` also has vanish.
bool may_move(const WorkingMesh& work, Vertex v, Vertex gone, const Vector3& place)
{
    const auto& surface = work.surface;
    for (const Halfedge h : CGAL::halfedges_around_target(surface.halfedge(v), surface))
    {
        const Vertex a = surface.source(h), b = surface.target(surface.next(h));
        if (surface.is_border(h) || a == gone || b == gone)
            continue;
        const Vector3 p = work.point(a), q = work.point(b), now = work.point(v);
        // A triangle without height may become any that has one.
        const double height = height_ratio(p, now, q);
        if (height > 1e-4
            && (height_ratio(p, place, q) < std::min(least_height, height)
                || !is_sound(WorkingMesh::area_vector(p, now, q),
                             WorkingMesh::area_vector(p, place, q))))
            return false;
    }
    return true;
}

bool grows_too_long(const WorkingMesh& work, Vertex v, Vertex gone, const Vector3& place)
{
    const auto& surface = work.surface;
    for (const Vertex other : CGAL::vertices_around_target(surface.halfedge(v), surface))
        if (other != gone
            && (work.point(other) - place).norm()
                   > too_long * 0.5 * (work.size[other] + work.size[v]))
            return true;
    return false;
}

void collapse_if_sound(WorkingMesh& work, Edge e)
{
    auto& surface = work.surface;
    Vertex a = surface.vertex(e, 0), b = surface.vertex(e, 1);
    if (work.is_frozen[a] && work.is_frozen[b])
        return;
    if (work.is_frozen[b])
        std::swap(a, b);
    const auto is_sound_at = [&](const Vector3& place)
    {
        return may_move(work, b, a, place) && (work.is_frozen[a] || may_move(work, a, b, place))
               && !grows_too_long(work, b, a, place) && !grows_too_long(work, a, b, place);
    };
    std::vector<Vector3> places{work.point(a)};
    if (!work.is_frozen[a])
        places = {0.5 * (work.point(a) + work.point(b)), work.point(a), work.point(b)};
    const auto place = std::find_if(places.begin(), places.end(), is_sound_at);
    if (place == places.end() || !CGAL::Euler::does_satisfy_link_condition(e, surface))
        return;
    const int origin = work.origin[a];
    const bool is_frozen = work.is_frozen[a];
    const double size = is_frozen ? work.size[a] : 0.5 * (work.size[a] + work.size[b]);
    const Vertex kept = CGAL::Euler::collapse_edge(e, surface, work.is_ridge);
    work.move(kept, *place);
    work.origin[kept] = origin;
    work.is_frozen[kept] = is_frozen;
    work.size[kept] = size;
}

// The mean of the middles of the triangles around, by area and the size wanted there, moved back
// into the plane of the vertex.
Vector3 smoothed_place(const WorkingMesh& work, Vertex v)
{
    const auto& surface = work.surface;
    Vector3 sum = Vector3::Zero(), normal = Vector3::Zero();
    double weight = 0.0;
    for (const Halfedge h : CGAL::halfedges_around_target(surface.halfedge(v), surface))
    {
        const Vertex a = surface.source(h), b = surface.target(surface.next(h));
        const Vector3 area = WorkingMesh::area_vector(work.point(a), work.point(v), work.point(b));
        const double size = (work.size[a] + work.size[v] + work.size[b]) / 3.0;
        const double share = area.norm() / (size * size);
        sum += share / 3.0 * (work.point(a) + work.point(v) + work.point(b));
        weight += share;
        normal += area;
    }
    if (weight <= 0.0)
        return work.point(v);
    const Vector3 step = sum / weight - work.point(v);
    normal.normalize();
    return work.point(v) + step - normal * normal.dot(step);
}

}  // namespace

int flip_to_delaunay(WorkingMesh& work, int most_rounds)
{
    int count = 0;
    for (int round = 0, flipped = 1; round < most_rounds && flipped > 0; ++round, count += flipped)
    {
        flipped = 0;
        for (const Edge e : work.surface.edges())
            if (!work.is_ridge[e])
                flipped += flip_if_better(work, e);
    }
    return count;
}

void even_sizes(WorkingMesh& work)
{
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
        for (const Edge e : work.surface.edges())
        {
            double& a = work.size[work.surface.vertex(e, 0)];
            double& b = work.size[work.surface.vertex(e, 1)];
            const double growth = size_growth * work.length(e);
            a = std::min(a, b + growth);
            b = std::min(b, a + growth);
        }
}

void split_long_edges(WorkingMesh& work)
{
    constexpr int most_rounds = 20;
    for (int round = 0; round < most_rounds; ++round)
    {
        even_sizes(work);
        std::vector<Edge> edges;
        for (const Edge e : work.surface.edges())
            if (!work.is_ridge[e] && work.length(e) > too_long * work.wanted_length(e))
                edges.push_back(e);
        for (const Edge e : edges)
            split(work, e);
        if (edges.empty())
            return;
    }
}

void collapse_short_edges(WorkingMesh& work)
{
    std::vector<Edge> edges;
    for (const Edge e : work.surface.edges())
        if (!work.is_ridge[e] && work.length(e) < too_short * work.wanted_length(e))
            edges.push_back(e);
    for (const Edge e : edges)
        if (!work.surface.is_removed(e) && work.length(e) < too_short * work.wanted_length(e))
            collapse_if_sound(work, e);
}

void smooth(WorkingMesh& work)
{
    for (const Vertex v : work.surface.vertices())
    {
        if (work.is_frozen[v])
            continue;
        const Vector3 place = smoothed_place(work, v);
        if (may_move(work, v, WorkingMesh::SurfaceMesh::null_vertex(), place))
            work.move(v, place);
    }
}

}  // namespace sheetmorph

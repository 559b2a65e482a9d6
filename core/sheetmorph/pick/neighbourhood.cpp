// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/pick/neighbourhood.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/regions/crease_loops.h"
#include "sheetmorph/mesh/regions/flags.h"
#include "sheetmorph/mesh/regions/growing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace sheetmorph::pick
{

namespace
{

void require_rings(int rings)
{
    if (rings < 0)
        throw InvalidInput("the number of rings is " + std::to_string(rings),
                           "it must be 0 or more");
}

}  // namespace

Neighbourhood::Neighbourhood(const mesh::TriangleMesh& mesh)
    : mesh_(mesh), edges_(mesh), triangles_(mesh)
{
    measure_bends();
}

void Neighbourhood::measure_bends()
{
    for (int t = 0; t < mesh_.triangle_count() && !has_thin_; ++t)
        has_thin_ = mesh::is_thin(mesh_.points(), mesh_.triangles(), t);
    bends_.resize(static_cast<std::size_t>(edges_.count()));
    for (int edge = 0; edge < edges_.count(); ++edge)
        if (const mesh::EdgeUses uses = edges_.uses(edge); uses.count() == 2)
            bends_[edge] = mesh::bend_angle(mesh_.points(), uses.first[0], uses.first[1]);
}

double Neighbourhood::bend(int edge, int triangle, const mesh::EdgeUse& other) const
{
    if (edges_.uses(edge).count() == 2)
        return bends_[edge];
    for (const mesh::EdgeUse& use : edges_.uses(edge))
        if (use.triangle == triangle)
            return mesh::bend_angle(mesh_.points(), use, other);
    return 0.0;
}

template <typename Visit>
void Neighbourhood::visit_around(int vertex, Visit&& visit) const
{
    for (const int t : triangles_.at(vertex))
        for (int k = 0; k < 3; ++k)
            visit(mesh_.triangles()(t, k));
}

std::vector<int> Neighbourhood::triangles_at(const VertexIds& vertices) const
{
    mesh::flags_of(vertices, mesh_.vertex_count(), "vertices");
    return triangles_.around(vertices);
}

VertexIds Neighbourhood::grown(const VertexIds& vertices, int rings) const
{
    require_rings(rings);
    mesh::Flags inside = mesh::flags_of(vertices, mesh_.vertex_count(), "vertices");
    VertexIds front = vertices;
    for (; rings > 0 && !front.empty(); --rings)
    {
        VertexIds reached;
        for (const int vertex : front)
            visit_around(vertex,
                         [&](int corner)
                         {
                             if (!inside[corner])
                                 reached.push_back(corner);
                             inside[corner] = 1;
                         });
        front = std::move(reached);
    }
    return mesh::ids_of(inside);
}

// A vertex is removed if it lies within `rings` rings of a vertex just outside the set.
VertexIds Neighbourhood::shrunk(const VertexIds& vertices, int rings) const
{
    mesh::Flags inside = mesh::flags_of(vertices, mesh_.vertex_count(), "vertices");
    VertexIds outside;
    for (const int vertex : vertices)
        visit_around(vertex,
                     [&](int corner)
                     {
                         if (!inside[corner])
                             outside.push_back(corner);
                     });
    for (const int vertex : grown(outside, rings))
        inside[vertex] = 0;
    return mesh::ids_of(inside);
}

// Uses the precomputed bends. Degenerate triangles are rare and have no bend of their own; they
// need the slower search.
std::vector<int> Neighbourhood::face(int triangle, double max_angle) const
{
    if (has_thin_ || !std::isfinite(max_angle))
        return mesh::grow_to_creases(mesh_, edges_, triangle, max_angle);
    mesh::Flags is_reached = mesh::flags_of({triangle}, mesh_.triangle_count(), "triangles");
    std::vector<int> front = {triangle};
    for (std::size_t next = 0; next < front.size(); ++next)
        for (int k = 0; k < 3; ++k)
        {
            const int edge = edges_.edge_of(front[next], k);
            for (const mesh::EdgeUse& use :
                 edge < 0 ? mesh::EdgeUses{nullptr, nullptr} : edges_.uses(edge))
                if (!is_reached[use.triangle] && bend(edge, front[next], use) < max_angle)
                {
                    is_reached[use.triangle] = 1;
                    front.push_back(use.triangle);
                }
        }
    return mesh::ids_of(is_reached);
}

std::vector<int> Neighbourhood::piece(int triangle) const
{
    mesh::flags_of({triangle}, mesh_.triangle_count(), "triangles");
    return triangles_at(grown({mesh_.triangles()(triangle, 0)}, mesh_.vertex_count()));
}

std::vector<VertexIds> Neighbourhood::pieces(const VertexIds& vertices) const
{
    mesh::Flags waiting = mesh::flags_of(vertices, mesh_.vertex_count(), "vertices");
    std::vector<VertexIds> found;
    for (const int first : mesh::ids_of(waiting))
    {
        if (!waiting[first])
            continue;
        waiting[first] = 0;
        VertexIds piece = {first};
        for (std::size_t next = 0; next < piece.size(); ++next)
            visit_around(piece[next],
                         [&](int corner)
                         {
                             if (waiting[corner])
                                 piece.push_back(corner);
                             waiting[corner] = 0;
                         });
        std::sort(piece.begin(), piece.end());
        found.push_back(std::move(piece));
    }
    return found;
}

std::vector<VertexIds> Neighbourhood::rims(double crease) const
{
    return mesh::crease_loops(mesh_, edges_, crease);
}

}  // namespace sheetmorph::pick

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/solid_pieces.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"

#include <algorithm>
#include <map>

namespace sheetmorph::recognise
{

namespace
{

// Minimum mean cosine between the normals of a hole's wall and the direction to its middle. From
// geometry: a slot 50 times as long as wide still exceeds it.
constexpr double looks_inwards = 0.02;

// The facets of every set, ordered by the root of the set.
std::vector<std::vector<int>> grouped(DisjointSets& sets, const std::vector<char>& is_member)
{
    std::map<int, std::vector<int>> groups;
    for (std::size_t t = 0; t < is_member.size(); ++t)
        if (is_member[t])
            groups[sets.root(static_cast<int>(t))].push_back(static_cast<int>(t));
    std::vector<std::vector<int>> found;
    for (auto& [root, facets] : groups)
        found.push_back(std::move(facets));
    return found;
}

VertexIds corners_of(const mesh::TriangleMesh& mesh, const std::vector<int>& facets)
{
    VertexIds corners;
    for (const int t : facets)
        for (int k = 0; k < 3; ++k)
            corners.push_back(mesh.triangles()(t, k));
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::vector<std::vector<int>> wall_facets(const FacetGraph& graph,
                                          const std::vector<SolidSide>& facets)
{
    std::vector<char> is_wall;
    for (const SolidSide side : facets)
        is_wall.push_back(side == SolidSide::wall);
    DisjointSets sets(graph.triangle_count());
    for (const FacetJoint& joint : graph.joints())
        if (is_wall[at(joint.one)] && is_wall[at(joint.other)])
            sets.join(joint.one, joint.other);
    return grouped(sets, is_wall);
}

bool goes_around_a_hole(const FacetGraph& graph, const std::vector<int>& facets)
{
    Vector3 middle = Vector3::Zero();
    double area = 0.0;
    for (const int t : facets)
    {
        middle += graph.area(t) * graph.centroid(t);
        area += graph.area(t);
    }
    if (area <= 0.0)
        return false;
    middle /= area;
    double inwards = 0.0, away = 0.0;
    for (const int t : facets)
    {
        const Vector3 way = middle - graph.centroid(t);
        inwards += graph.area(t) * way.dot(graph.normal(t));
        away += graph.area(t) * way.norm();
    }
    return inwards > looks_inwards * away;
}

bool has_side(const VertexIds& vertices, const ThinSolid& solid, SolidSide side)
{
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](int v) { return solid.vertices[at(v)] == side; });
}

void sort_pieces(std::vector<VertexIds>& pieces)
{
    std::sort(pieces.begin(), pieces.end());
}

}  // namespace

std::vector<VertexIds> wall_pieces(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                                   const std::vector<SolidSide>& facets)
{
    std::vector<VertexIds> pieces;
    for (const std::vector<int>& wall : wall_facets(graph, facets))
        pieces.push_back(corners_of(mesh, wall));
    sort_pieces(pieces);
    return pieces;
}

std::vector<ThroughHole> through_holes(const mesh::TriangleMesh& mesh, const FacetGraph& graph,
                                       const ThinSolid& solid)
{
    std::vector<ThroughHole> holes;
    for (const std::vector<int>& facets : wall_facets(graph, solid.facets))
    {
        ThroughHole hole;
        hole.vertices = corners_of(mesh, facets);
        if (!has_side(hole.vertices, solid, SolidSide::main)
            || !has_side(hole.vertices, solid, SolidSide::opposite)
            || !goes_around_a_hole(graph, facets))
            continue;
        for (const int vertex : hole.vertices)
            if (solid.vertices[at(vertex)] == SolidSide::main)
                hole.rim.push_back(vertex);
        holes.push_back(std::move(hole));
    }
    std::sort(holes.begin(), holes.end(),
              [](const ThroughHole& a, const ThroughHole& b) { return a.vertices < b.vertices; });
    return holes;
}

std::vector<VertexIds> lump_pieces(const mesh::TriangleMesh& mesh,
                                   const std::vector<InwardProbe>& probes,
                                   const std::vector<char>& is_lump)
{
    const int count = mesh.triangle_count();
    DisjointSets sets(count);
    std::vector<int> first(at(mesh.vertex_count()), -1);
    for (int t = 0; t < count; ++t)
        for (int k = 0; k < 3 && is_lump[at(t)]; ++k)
        {
            int& of_vertex = first[at(mesh.triangles()(t, k))];
            of_vertex = of_vertex < 0 ? t : of_vertex;
            sets.join(of_vertex, t);
        }
    for (const InwardProbe& probe : probes)
        if (is_lump[at(probe.facet)] && probe.opposite >= 0 && is_lump[at(probe.opposite)])
            sets.join(probe.facet, probe.opposite);
    std::vector<VertexIds> pieces;
    for (const std::vector<int>& lump : grouped(sets, is_lump))
        pieces.push_back(corners_of(mesh, lump));
    sort_pieces(pieces);
    return pieces;
}

}  // namespace sheetmorph::recognise
